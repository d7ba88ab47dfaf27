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

/// Whether a step of so many unknowns, other than 0, meets conditions that 0 meets with equality: then other
/// parameters are as good as those from which it goes. If there is none, 0 is the nearest of the allowed
/// steps to each step along a coordinate, which is 1 long. The programme leaves less than a millionth of that
/// step.
bool has_way_on(std::span<const Condition> conditions, Eigen::Index unknowns);

}  // namespace shadefit
