#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_nodes.hpp"

namespace shadefit {

/// A least-squares optimum over nodes, rounded from 50 digits.
struct LinearOptimum {
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  Vector parameters;
  Vector last_step;        ///< to them
  Vector spread;           ///< how far errors with a root mean square of 1 may move each parameter
  long double square = 0;  ///< of the error
};

/// Gauss and Newton's method in 50 digits, from a start: one step is enough for a form that is linear in its
/// parameters. Long double would leave the rounding of the target, and the normal equations have the square
/// of the columns' condition number: for x^0 to x^7 on [0, 1] this is 1e10, for 1 and x on [1e9, 1e9 + 1] it
/// is 1e19. Empty if the columns are dependent.
std::optional<LinearOptimum> optimum_in_50_digits(const ReadStudy& study, const StudyNodes& nodes,
                                                  const std::vector<double>& start);

}  // namespace shadefit
