#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/least_squares/status.hpp"
#include "fit/minimax/alternation.hpp"

/// What a solver answers.
namespace shadefit {

/// The result of a solver, with all parameters of the family in its order.
struct Solution {
  std::vector<double> parameters;
  Status status = Status::not_converged;
  int iterations = 0;
  int digits = 0;
  double rms_error = 0;  ///< sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2)
  std::optional<double> level = std::nullopt;
  std::vector<AlternationPoint> alternation = {};
  std::string why = {};
};

}  // namespace shadefit
