#pragma once

#include <Eigen/Core>
#include <functional>

/// Steps of Levenberg and Marquardt, by ceres::TinySolver: compiled once, for every problem.
namespace shadefit {

/// Residuals whose sum of squares is to fall.
struct Residuals {
  Eigen::Index count;
  /// The residuals at some parameters and, if `jacobian` is not null, their derivatives, one column for each
  /// parameter.
  std::function<void(const double* parameters, double* residuals, double* jacobian)> evaluate;
};

/// How long a descent goes on.
struct Patience {
  double last_step;  ///< it ends with a step below this, relative
  int most_steps;
  double last_change = 0;  ///< it ends with a change of the sum of squares below this
};

/// Moves the parameters down. Returns the number of steps.
int descend(const Residuals& residuals, const Patience& patience, Eigen::Ref<Eigen::VectorXd> parameters);

}  // namespace shadefit
