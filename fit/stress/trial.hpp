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

/// Forms of one quantity, naive and robust, tried in half, float and double at the same inputs, against its
/// exact formula in 50 digits of these inputs.
namespace shadefit {

/// A form in a format: numbers of it in, a number of it out, all held as doubles.
using NumberFunction = double (*)(double, double);
/// The same in half, float and double.
using InFormats = std::array<NumberFunction, 3>;

inline constexpr std::array stress_formats{half_format, float_format, double_format};

/// A generic captureless function of two scalars of one type, in each format.
template <class Formula>
InFormats in_formats(Formula) {
  const auto evaluate = []<class T>(std::type_identity<T>) -> NumberFunction {
    return [](double a, double b) { return widened(Formula{}(rounded_to<T>(a), rounded_to<T>(b))); };
  };
  return {evaluate(std::type_identity<Eigen::half>{}), evaluate(std::type_identity<float>{}),
          evaluate(std::type_identity<double>{})};
}

/// How far a robust form may be off, as a count of its roundings. With p digits an operation is off by
/// u = 2^-p of its result at most, and so is a function of half, which is rounded once; a function of float
/// or double by an ulp, 2 u (the manual of the GNU C library, "Errors in Math Functions", x86_64). n of them
/// are off by (1 + u)^n - 1 < e^(n u) - 1 of the result, and u of a number is an ulp of it at most: n
/// roundings are n ulps, a little more where n u is no longer small.
///
/// An error in the exponent of an exponential is multiplied by that exponent: `per_fold` is what each e-fold
/// by which the exponential has fallen (or risen) adds.
struct Roundings {
  double operations = 0, functions = 0;
  double operations_per_fold = 0, functions_per_fold = 0;

  double fixed(const BinaryFormat& format) const;
  double per_fold(const BinaryFormat& format) const;
};

/// "2 + 3 L", L the e-folds.
std::string bound_text(const Roundings& roundings, const BinaryFormat& format);

/// The ulps that they amount to after so many e-folds.
double bound_ulps(const Roundings& roundings, const BinaryFormat& format, double folds);

struct StressedForm {
  std::string_view name;
  std::string formula;
  InFormats evaluate;
  std::optional<Roundings> bound = std::nullopt;  ///< of a robust form; a naive one promises nothing
};

/// What a regime asks of its forms.
struct Regime {
  std::string_view topic;                 ///< "lobe", "phase" ..
  std::string domain;                     ///< where the inputs lie, in words
  std::array<std::string_view, 2> names;  ///< of the inputs; the second may be empty
  std::vector<StressedForm> forms;
  Decimal50 (*truth)(const Decimal50&, const Decimal50&);
  /// The e-folds of the exponential in a form; null where there is none.
  double (*folds)(double, double) = nullptr;
  std::optional<double> at_most = std::nullopt;  ///< the largest value that the exact formula takes
  bool is_positive = true;                       ///< the exact formula is nowhere negative
  std::function<std::vector<Input>(const BinaryFormat&, std::size_t random)> inputs;
};

/// What came of one form in one format.
struct FormTrial {
  std::string_view topic, form;
  std::string formula, domain;
  BinaryFormat format = double_format;
  std::optional<Roundings> bound;
  long inputs = 0;
  double worst_ulps = 0;   ///< of the results that are numbers
  std::string worst_at;    ///< the first input that is more than half as bad as the worst; as text, empty if
                           ///< nothing is wrong
  double worst_share = 0;  ///< of a robust form: the most of its bound that an error takes up
  long nan = 0, infinite = 0, negative = 0;  ///< results that are none, where the truth is a number of the
                                             ///< format that is not negative
  std::optional<long> above;                 ///< results above the largest value, where there is one
  std::string first_bad;                     ///< the first input that any of these counts counts
  std::string first_broken;                  ///< of a robust form: the first input beyond its bound

  bool is_robust() const { return bound.has_value(); }
  /// Whether the form keeps what it states: the bound, and no result that is none.
  bool is_kept() const { return first_broken.empty() && first_bad.empty(); }
};

/// Tries the forms of a regime in each format, at its edges and at about that many random inputs.
std::vector<FormTrial> try_forms(const Regime& regime, std::size_t random,
                                 const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
