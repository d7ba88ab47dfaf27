#include "fit/steps/levenberg.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shadefit {
namespace {

// The sum of (p_0 + p_1 x_i + .. - e^(x_i))^2 falls to the interpolation where there are as many values as
// parameters, and to the answer of the normal equations where there are more: on the stack with one more,
// else on the heap.
TEST(Levenberg, SolvesLinearProblemsOfEverySize) {
  for (const int n : {1, 2, 3, 4, 5}) {
    for (const int count : {n, n + 1, 12, 20}) {
      Eigen::MatrixXd slopes(count, n);
      Eigen::VectorXd values(count);
      for (int i = 0; i < count; ++i) {
        const double x = count == 1 ? 0.5 : static_cast<double>(i) / (count - 1);
        values[i] = std::exp(x);
        for (int j = 0; j < n; ++j) slopes(i, j) = std::pow(2 * x - 1, j);
      }
      const Residuals residuals{count, [&](const double* p, double* r, double* jacobian) {
                                  Eigen::Map<Eigen::VectorXd>(r, count) =
                                      slopes * Eigen::Map<const Eigen::VectorXd>(p, n) - values;
                                  if (jacobian != nullptr)
                                    Eigen::Map<Eigen::MatrixXd>(jacobian, count, n) = slopes;
                                }};
      Eigen::VectorXd p = Eigen::VectorXd::Zero(n);
      const int steps = descend(residuals, {.last_step = 1e-10, .most_steps = 50}, p);
      EXPECT_LT(steps, 20) << n << " of " << count;
      const Eigen::VectorXd rest = slopes.transpose() * (slopes * p - values);
      // Steps are accepted by the sum of squares, which is flat to the root of its rounding: that is 2e-8 of
      // the parameters, and no product of two columns exceeds 20.
      EXPECT_LT(rest.norm(), 4e-7) << n << " of " << count;
    }
  }
}

}  // namespace
}  // namespace shadefit
