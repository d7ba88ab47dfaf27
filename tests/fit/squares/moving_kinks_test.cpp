#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/squares/solve_study.hpp"
#include "fit/study/study.hpp"
#include "tests/refusal.hpp"

/// Forms whose parameters move a kink.
namespace shadefit {
namespace {

StudyFit fit_of(const std::string& target, const std::string& form) {
  const Study study{.target = target, .form = form, .over = {{"x", "0", "1"}}};
  return solve_study(read_study(study), {});
}

void expect_fit(const std::string& target, const std::string& form, const std::vector<double>& parameters) {
  const StudyFit fit = fit_of(target, form);
  ASSERT_EQ(name(fit.status), "converged") << form << ": " << fit.why;
  EXPECT_FALSE(fit.is_global) << form;
  EXPECT_GE(fit.digits, 12) << form;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    EXPECT_NEAR(fit.parameters[i] / parameters[i], 1, 1e-13) << form << ", " << fit.names[i];
}

// The zero of the gradient by mpmath: `findroot` in 30 digits on integrals that end at the kinks.
TEST(MovingKinks, AreSettledWhereTheyAre) {
  expect_fit("x^2", "saturate(a x + b)",
             {1.28989794855663561963945681494, -0.373938769133981371783674088965});
  expect_fit("x^2", "max(a x + b, 0)", {1.28989794855663561963945681494, -0.373938769133981371783674088965});
  expect_fit("sqrt(x)", "min(a x, b)", {1.65575507653592548713469635586, 0.869693845669906858918370444824});
  expect_fit("smoothstep(0.2, 0.8, x)", "saturate(a x + b)",
             {2.21756825295048940691415168453, -0.608784126475244703457075842264});
}

TEST(MovingKinks, AreFoundWhereTheFormIsTheTarget) {
  expect_fit("max(x, 0.3)", "max(a x, b)", {1, 0.3});
  expect_fit("min(5 x, 1)", "min(a x, 1)", {5});
  expect_fit("saturate(3 x - 1)", "saturate(a x + b)", {3, -1});
}

// A parameter that only moves a jump has no derivative; one that is 0 by its algebra is none; and one without
// an effect at the optimum leaves it open.
TEST(MovingKinks, SayWhatTheFormDoesNotDependOn) {
  const auto refusal = [](const std::string& form) { return testing::refusal([&] { fit_of("x^2", form); }); };
  EXPECT_EQ(refusal("x > a ? b x : 0"),
            "--form has no derivative by its parameter 'a', which only moves a jump: hold it, for example by "
            "--fix a=0.5");
  EXPECT_EQ(refusal("x + 0 a"), "--form does not depend on its parameter 'a'");
  const StudyFit flat = fit_of("x", "saturate(100 + a^2) x");
  EXPECT_EQ(name(flat.status), "degenerate");
  EXPECT_EQ(flat.why, "the curve stays the same while a changes");
}

}  // namespace
}  // namespace shadefit
