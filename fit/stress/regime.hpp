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
#include "fit/stress/trial.hpp"
#include "fit/support/checkpoint.hpp"

/// Tests naive and robust forms of one quantity in half, float and double, at the same inputs, against its
/// exact formula in 50 digits.
namespace shadefit {

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
  /// By how many factors of e the exponential of the forms falls or rises; null if they have none.
  double (*folds)(double, double) = nullptr;
  std::optional<double> at_most = std::nullopt;  ///< the largest value of the exact formula
  bool is_positive = true;                       ///< the exact formula is never negative
  std::function<std::vector<Input>(const BinaryFormat&, std::size_t random)> inputs;
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
