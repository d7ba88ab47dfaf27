#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fit/errors/ulps.hpp"
#include "fit/scalars/half.hpp"
#include "fit/stress/form_trial.hpp"
#include "fit/stress/numbers.hpp"

/// Forms under stress: the usual and a robust form of one quantity in half, float and double, at the same
/// inputs, against its exact formula in 50 digits.
namespace shadefit {

inline constexpr std::array stress_formats{half_format, float_format, double_format};

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

/// Tests the forms of a regime in each format, at its edges and at about that many random inputs.
std::vector<FormTrial> try_forms(const Regime& regime, std::size_t random);

/// Lobes near their peak, lobes of a dot product, which may be beyond [0, 1], and Schlick's weight of one.
std::vector<Regime> stress_regimes();

}  // namespace shadefit
