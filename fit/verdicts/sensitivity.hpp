#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/fit.hpp"
#include "fit/support/checkpoint.hpp"

/// How well the constants of a fit have to be known, and how they depend on what was asked for. A
/// deterministic approximation has no covariance: its honest uncertainty is how far a constant may move
/// before the objective, the rms or the largest error, is noticeably worse.
namespace shadefit {

/// What a worsening of the objective by one part in a hundred, or in a thousand, leaves to a constant.
inline constexpr double noticeable = 0.01, slight = 0.001;

struct ParameterSensitivity {
  std::string_view parameter;
  double value;
  /// The decimals with the fewest significant digits that worsen the objective by less than `noticeable` and
  /// `slight`, the other constants as fitted.
  std::string noticeable_digits, slight_digits;
  /// The profile interval: within it, the other constants fitted anew, the objective is worse by less than
  /// `noticeable`. Empty where it goes on beyond a hundred times the constant, or where a fit there fails.
  std::optional<double> lower, upper;
};

/// All constants of a fit with so many significant digits.
struct CommonDigits {
  int digits;
  std::vector<std::string> parameters;
  double objective;
};

/// A fit under a contract that differs in one thing.
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

/// Of a fit that converged and that no constraints bind but given parameters: constants that are rounded meet
/// no other. The contracts: the fit's own, then other measures where the norm has one, then domains that
/// leave a tenth of the cosines out at one end or both.
Sensitivity sensitivity_of(const Fit& fit, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
