#include "fit/steps/scaled_hessian.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace shadefit {
namespace {

// The step is that of a known answer.
TEST(ScaledHessian, SolvesForAnyNumberOfParameters) {
  for (const int n : {1, 2, 3, 4, 5, 9, most_fitted}) {
    ParameterMatrix<double> hessian(n, n);
    ParameterVector<double> expected(n);
    for (int i = 0; i < n; ++i) {
      expected[i] = 1 + i;
      for (int j = 0; j < n; ++j) hessian(i, j) = 1.0 / (1 + std::abs(i - j)) + (i == j ? n : 0);
    }
    const ParameterVector<double> found = ScaledHessian(hessian).inverse() * (hessian * expected);
    // The diagonal is at least half of a row's sum: the condition is small, and a sum has at most 16 terms.
    EXPECT_LT((found - expected).norm(), 1e-14 * expected.norm()) << n;
    EXPECT_TRUE(is_minimum(hessian)) << n;
    hessian(n - 1, n - 1) = -1;
    EXPECT_FALSE(is_minimum(hessian)) << n;
  }
}

}  // namespace
}  // namespace shadefit
