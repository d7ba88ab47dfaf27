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
#include "fit/scalars/half.hpp"
#include "fit/stress/numbers.hpp"
#include "fit/support/checkpoint.hpp"

/// Forms under stress: the usual and a robust form of one quantity in half, float and double, at the same
/// inputs, against its exact formula in 50 digits.
namespace shadefit {

inline constexpr std::array stress_formats{half_format, float_format, double_format};

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

/// A form in a format. Its arguments and its result are numbers of the format, stored as doubles.
using NumberFunction = double (*)(double, double);
/// The same in half, float and double.
using InFormats = std::array<NumberFunction, 3>;

/// A generic function without captures of two scalars of one type, in each format.
template <class Formula>
InFormats in_formats(Formula) {
  const auto evaluate = []<class T>(std::type_identity<T>) -> NumberFunction {
    return [](double a, double b) { return widened(Formula{}(rounded_to<T>(a), rounded_to<T>(b))); };
  };
  return {evaluate(std::type_identity<Eigen::half>{}), evaluate(std::type_identity<float>{}),
          evaluate(std::type_identity<double>{})};
}

struct StressedForm {
  std::string_view name, formula;
  InFormats evaluate;
  std::optional<Roundings> bound = std::nullopt;  ///< of a robust form; a naive one promises nothing
};

/// A quantity in [0, 1] with its forms and inputs.
struct Regime {
  std::string_view topic, domain;         ///< the range of the inputs, in words
  std::array<std::string_view, 2> names;  ///< of the inputs; the second may be empty
  std::vector<StressedForm> forms;
  Decimal50 (*truth)(const Decimal50&, const Decimal50&);
  /// By how many factors of e the exponential of the forms falls; null if they have none.
  double (*folds)(double, double);
  std::function<std::vector<Input>(const BinaryFormat&, std::size_t random)> inputs;
};

/// The result of one form in one format.
struct FormTrial {
  std::string_view topic, form, formula, domain;
  BinaryFormat format = double_format;
  std::optional<Roundings> bound = {};
  long inputs = 0;
  double worst_ulps = 0;      ///< of the results that are numbers
  std::string worst_at = {};  ///< the first input with more than half of the worst error
  long nan = 0, infinite = 0, negative = 0, above = 0;  ///< unusable results; above 1
  std::string first_bad = {};                           ///< the first input of these results
  std::string first_broken = {};  ///< of a robust form: the first input beyond its bound

  /// Whether the form keeps its bound and has no unusable result.
  bool is_kept() const { return first_broken.empty() && first_bad.empty(); }
};

/// Tests the forms of a regime in each format, at its edges and at about that many random inputs.
std::vector<FormTrial> try_forms(const Regime& regime, std::size_t random);

/// Lobes near their peak, lobes of a dot product, which may be beyond [0, 1], and Schlick's weight of one.
std::vector<Regime> stress_regimes();

/// The forms of all regimes.
std::vector<FormTrial> forms_under_stress(const Checkpoint& checkpoint);

}  // namespace shadefit
