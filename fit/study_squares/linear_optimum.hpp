#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace shadefit {

/// The least squares of a form that is linear in all its parameters.
struct LinearOptimum {
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  Vector parameters;
  Vector last_step;        ///< of its refinement, which is rounding
  Vector sizes;            ///< how much a parameter of 1 moves the form: a root mean square
  long double square = 0;  ///< of the error
};

/// The weighted errors at these parameters, and a column of their derivatives for each parameter.
using LinearErrors =
    std::function<void(const std::vector<long double>& parameters, LinearOptimum::Vector& errors,
                       Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>& slopes)>;

/// Solved in long double, by orthogonal columns. The Hessian would have the square of their condition number:
/// for x^0 to x^7 on [0, 1] this is 1e10, and for x^15 it is beyond a double. Empty if the columns are
/// dependent up to the rounding of long double.
std::optional<LinearOptimum> linear_optimum(std::size_t parameter_count, const LinearErrors& errors);

/// The x for which `columns` x - `target` has the least square, in double, by orthogonal columns.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target);

}  // namespace shadefit
