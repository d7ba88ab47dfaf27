#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/least_squares/status.hpp"
#include "fit/minimax/alternation.hpp"

/// What a solver answers.
namespace shadefit {

struct Solution {
  std::vector<double> parameters;  ///< in the order of the family; an answer only if `status` is converged
  Status status = Status::not_converged;
  int digits = 0;  ///< correct digits of the worst parameter, at most 14
  /// sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2), with the error of the
  /// metric. A constant weight changes nothing. Never above the largest error.
  double rms_error = 0;
  std::optional<double> level = std::nullopt;      ///< of a minimax fit: the largest weight * |error|
  std::vector<AlternationPoint> alternation = {};  ///< of a minimax fit
  std::string why = {};  ///< of a fit that did not converge, if its status is not enough
};

}  // namespace shadefit
