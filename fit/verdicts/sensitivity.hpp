#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/study_verdict.hpp"

/// The digits of a fit's constants that matter, and the dependence of the constants on density and range. A
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

/// A fit whose objective differs in one respect.
struct OtherFit {
  std::string under;  ///< "least squares, measure angle", "least squares, x in 0.1:1"
  StudyFit fit;
};

struct Sensitivity {
  double objective;  ///< of the fit: its rms error, or the largest weight * |error|
  std::vector<ParameterSensitivity> parameters = {};
  std::optional<CommonDigits> noticeable_digits = std::nullopt, slight_digits = std::nullopt;
  std::vector<OtherFit> others = {};  ///< the own fit first; of one variable
};

/// The sensitivity of a converged fit. The other objectives are the measures of a cosine if the range is
/// inside [0, 1], then ranges without a tenth at one end or both. Throws UserError for constraints, because
/// rounded constants do not meet them, and for measured rows, because their fits have profile intervals.
Sensitivity sensitivity_of(const StudyObjective& objective, const StudyFit& fit,
                           const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
