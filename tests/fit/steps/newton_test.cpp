#include "fit/steps/newton.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace shadefit {
namespace {

// Five and more parameters, which no family has: the inverse is not a closed form, and the step is that of a
// known answer.
TEST(NewtonStep, SolvesForAnyNumberOfParameters) {
  for (const int n : {1, 2, 3, 4, 5, 9, most_fitted}) {
    ParameterMatrix<double> hessian(n, n);
    ParameterVector<double> expected(n);
    for (int i = 0; i < n; ++i) {
      expected[i] = 1 + i;
      for (int j = 0; j < n; ++j) hessian(i, j) = 1.0 / (1 + std::abs(i - j)) + (i == j ? n : 0);
    }
    const ParameterVector<double> gradient = -hessian * expected;
    const ParameterVector<double> step = newton_step(gradient, hessian);
    // The diagonal is at least half of a row's sum: the condition is small, and a sum has at most 16 terms.
    EXPECT_LT((step - expected).norm(), 1e-14 * expected.norm()) << n;
    EXPECT_TRUE(is_minimum(hessian)) << n;
    hessian(n - 1, n - 1) = -1;
    EXPECT_FALSE(is_minimum(hessian)) << n;
  }
}

// The correction recovers a quadratic from steps: independent steps give all of it.
TEST(Correct, FindsAHessianFromItsSteps) {
  const Eigen::Matrix2d truth{{3, 1}, {1, 2}};
  ParameterMatrix<double> hessian = Eigen::Matrix2d{{5, 0}, {0, 1}};
  for (const Eigen::Vector2d& step : {Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1)})
    correct(hessian, step, truth * step);
  EXPECT_LT((hessian - truth).norm(), 1e-14);
  correct(hessian, Eigen::Vector2d(1, 2), truth * Eigen::Vector2d(1, 2));
  EXPECT_LT((hessian - truth).norm(), 1e-14) << "nothing is learnt from what was expected";
}

}  // namespace
}  // namespace shadefit
