#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/support/checkpoint.hpp"

/// The digits of a fit's constants that matter, and the dependence of the constants on measure and domain. A
/// deterministic approximation has no covariance. Its uncertainty is the distance that a constant may move
/// before the objective (the rms or the largest error) is noticeably worse.
namespace shadefit {

/// The freedom of a constant if the objective may be worse by one part in a hundred, or in a thousand.
inline constexpr double noticeable = 0.01, slight = 0.001;

struct ParameterSensitivity {
  std::string parameter;
  double value;
  /// The shortest decimals that worsen the objective by less than `noticeable` and `slight`, with the other
  /// constants as fitted.
  std::string noticeable_digits, slight_digits;
  /// The profile interval: inside it the objective is worse by less than `noticeable`, with the other
  /// constants fitted again. Empty if it extends beyond a hundred times the constant, or if a fit fails.
  std::optional<double> lower, upper;
};

/// All constants of a fit, rounded to the same number of digits.
struct CommonDigits {
  int digits;
  std::vector<std::string> parameters;
  double objective;
};

/// A fit whose metric differs in one respect.
struct OtherContract {
  Metric metric;
  Fit fit;
};

struct Sensitivity {
  double objective;  ///< of the fit: its rms error, or the largest weight * |error|
  std::vector<ParameterSensitivity> parameters = {};
  std::optional<CommonDigits> noticeable_digits = std::nullopt, slight_digits = std::nullopt;
  std::vector<OtherContract> contracts = {};
};

/// Fitted constants and what they cost.
struct FittedConstants {
  std::vector<std::string> names;
  std::vector<double> values;
  std::vector<bool> is_given;  ///< of a constant that was not fitted and stays
  /// The objective at other values.
  std::function<double(const std::vector<double>&)> objective;
  /// The least objective with constant i held at a value; NaN if that fit fails.
  std::function<double(std::size_t, double)> profile;
};

/// The sensitivity of fitted constants, without other contracts.
Sensitivity sensitivity_of(const FittedConstants& constants, const Checkpoint& checkpoint = keep_going);

/// The sensitivity of a converged fit. Given parameters are the only constraints that are possible, because
/// rounded constants do not meet others. The metrics: the fit's own, then other measures if the norm has one,
/// then domains without a tenth of the cosines at one end or both.
Sensitivity sensitivity_of(const Fit& fit, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
