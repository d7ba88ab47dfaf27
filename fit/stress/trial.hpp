#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fit/errors/ulps.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/stress/numbers.hpp"
#include "fit/support/checkpoint.hpp"

/// Tests naive and robust forms of one quantity in half, float and double, at the same inputs, against its
/// exact formula in 50 digits.
namespace shadefit {

/// A form in a format. Its arguments and its result are numbers of the format, stored as doubles.
using NumberFunction = double (*)(double, double);
/// The same in half, float and double.
using InFormats = std::array<NumberFunction, 3>;

inline constexpr std::array stress_formats{half_format, float_format, double_format};

/// A generic function without captures of two scalars of one type, in each format.
template <class Formula>
InFormats in_formats(Formula) {
  const auto evaluate = []<class T>(std::type_identity<T>) -> NumberFunction {
    return [](double a, double b) { return widened(Formula{}(rounded_to<T>(a), rounded_to<T>(b))); };
  };
  return {evaluate(std::type_identity<Eigen::half>{}), evaluate(std::type_identity<float>{}),
          evaluate(std::type_identity<double>{})};
}

/// The bound on the error of a robust form, as a count of its roundings. With p digits an operation is off by
/// u = 2^-p of its result at most, and so is a function of half, which is rounded once; a function of float
/// or double by an ulp, 2 u (the manual of the GNU C library, "Errors in Math Functions", x86_64). n of them
/// are off by (1 + u)^n - 1 < e^(n u) - 1 of the result, and u times a number is at most an ulp of it: n
/// roundings are n ulps, slightly more if n u is not small.
///
/// An error in the exponent of an exponential is multiplied by that exponent: each e-fold by which the
/// exponential has fallen (or risen) adds `per_fold`.
struct Roundings {
  double operations = 0, functions = 0;
  double operations_per_fold = 0, functions_per_fold = 0;

  double fixed(const BinaryFormat& format) const;
  double per_fold(const BinaryFormat& format) const;
};

/// "2 + 3 L", L the e-folds.
std::string bound_text(const Roundings& roundings, const BinaryFormat& format);

/// The bound in ulps after so many e-folds.
double bound_ulps(const Roundings& roundings, const BinaryFormat& format, double folds);

struct StressedForm {
  std::string_view name;
  std::string formula;
  InFormats evaluate;
  std::optional<Roundings> bound = std::nullopt;  ///< of a robust form; a naive one promises nothing
};

/// A quantity with its forms, inputs and requirements.
struct Regime {
  std::string_view topic;                 ///< "lobe", "phase" ..
  std::string domain;                     ///< the range of the inputs, in words
  std::array<std::string_view, 2> names;  ///< of the inputs; the second may be empty
  std::vector<StressedForm> forms;
  Decimal50 (*truth)(const Decimal50&, const Decimal50&);
  /// The e-folds of the exponential in a form; null if there is none.
  double (*folds)(double, double) = nullptr;
  std::optional<double> at_most = std::nullopt;  ///< the largest value of the exact formula
  bool is_positive = true;                       ///< the exact formula is never negative
  std::function<std::vector<Input>(const BinaryFormat&, std::size_t random)> inputs;
};

/// The result of one form in one format.
struct FormTrial {
  std::string_view topic, form;
  std::string formula, domain;
  BinaryFormat format = double_format;
  std::optional<Roundings> bound = {};
  long inputs = 0;
  double worst_ulps = 0;      ///< of the results that are numbers
  std::string worst_at = {};  ///< the first input with more than half of the worst error, as text; empty if
                              ///< nothing is wrong
  double worst_share = 0;     ///< of a robust form: the largest ratio of an error to its bound
  long nan = 0, infinite = 0,
       negative = 0;  ///< unusable results, where the truth is a number of the format that is not negative
  std::optional<long> above = {};  ///< results above the largest value, if there is one
  std::string first_bad = {};      ///< the first input of these results
  std::string first_broken = {};   ///< of a robust form: the first input beyond its bound

  bool is_robust() const { return bound.has_value(); }
  /// Whether the form keeps its bound and has no unusable result.
  bool is_kept() const { return first_broken.empty() && first_bad.empty(); }
};

/// Tests the forms of a regime in each format, at its edges and at about that many random inputs.
std::vector<FormTrial> try_forms(const Regime& regime, std::size_t random,
                                 const Checkpoint& checkpoint = keep_going);

// The regimes, one file for each topic.

std::vector<Regime> lobe_regimes();              ///< c^k near its peak; its Gaussian with A; the half angle
std::vector<Regime> dot_product_regimes();       ///< c at and beyond the ends of [0, 1]
std::vector<Regime> von_mises_fisher_regimes();  ///< its normalised density
std::vector<Regime> phase_regimes();             ///< Henyey-Greenstein
std::vector<Regime> normalisation_regimes();     ///< of Blinn-Phong
std::vector<Regime> gloss_regimes();             ///< decoding
std::vector<Regime> remainder_regimes();         ///< log1p(x) - x

}  // namespace shadefit
