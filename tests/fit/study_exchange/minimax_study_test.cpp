#include "fit/study_exchange/minimax_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/support/user_error.hpp"

/// Minimax fits of studies of one variable where the exchange is easily led astray.
namespace shadefit {
namespace {

StudyFit fit_of(const Study& study) {
  return solve_minimax_study(read_study(study), {}, {});
}

// Least squares finds a = 1, b = 50, where the error is 0. A sine of another frequency has the level 1.
TEST(MinimaxStudy, CallsNoWorseLevelConverged) {
  const Study wave{.target = "sin(50 x)", .form = "a sin(b x)", .over = {{"x", "0", "1"}}};
  const StudyFit exact = fit_of(wave);
  EXPECT_NE(name(exact.status), "converged") << *exact.level;
  EXPECT_NEAR(exact.parameters[0] * exact.parameters[1], 50, 1e-9);
  Study disturbed = wave;
  disturbed.target = "sin(50 x) + x/10";
  const StudyFit fit = fit_of(disturbed);
  if (fit.status == Status::converged) {
    EXPECT_LT(*fit.level, 0.11);
  }
}

}  // namespace
}  // namespace shadefit
