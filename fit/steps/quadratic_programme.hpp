#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/steps/linear_programme.hpp"

namespace shadefit {

/// A condition that the answer meets with equality, and its multiplier: >= 0 except for an equation.
struct ActiveCondition {
  std::size_t condition;
  double multiplier;
};

struct QuadraticAnswer {
  Eigen::VectorXd step;
  std::vector<ActiveCondition> active;
};

/// The step d that minimises d^T hessian d / 2 + gradient^T d under the conditions slope^T d <= bound, or =
/// bound. `hessian` is positive definite; the slope by the level is ignored. Empty if no step meets the
/// conditions.
///
/// The dual method of Goldfarb, Idnani 1983, "A numerically stable dual method for solving strictly convex
/// quadratic programs", Mathematical Programming 27. It starts from the step without conditions and meets the
/// most violated one after the other. A condition whose multiplier falls to 0 on the way is dropped.
std::optional<QuadraticAnswer> least_step(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                                          std::span<const Condition> conditions);

/// Whether some step meets the conditions, each of which the step 0 meets with equality. Such a step leads to
/// other parameters that are equally good. If no other step meets them, then 0 is the allowed step that is
/// nearest to each unit step along a coordinate. The answer counts as 0 if it is shorter than a millionth.
bool has_way_on(std::span<const Condition> conditions, Eigen::Index unknowns);

}  // namespace shadefit
