#include "fit/catalogue/near_peak.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/catalogue/fit_study.hpp"

namespace shadefit {
namespace {

/// A spherical Gaussian for c^k, with formulas of y = 1 - c.
Study lobe(const std::string& exponent, const std::string& density = "1") {
  return {.target = "c^k",
          .form = "exp((k + x) (c - 1))",
          .over = {{"c", "0", "1", density}},
          .definitions = {{"y", {}, "1 - c"}},
          .given = {{"k", exponent}},
          .near_peak = {"exp(k log1p(-y))", "exp(-(k + x) y)"}};
}

TEST(NearPeak, AStudyWithoutAPeakStaysAsItIs) {
  const Study plain{.target = "x^2", .form = "a x", .over = {{"x", "0", "1"}}};
  EXPECT_FALSE(has_peak(plain));
  EXPECT_EQ(near_peak(plain).over.front().variable, "x");
  EXPECT_EQ(peak_variable(plain).cosine_at(0.25).cos_theta, 0.25);
}

TEST(NearPeak, ASharpLobeHasAVariableInWhichAllAreEquallyWide) {
  const Study sharp = near_peak(lobe("1e6"));
  EXPECT_EQ(sharp.over.front().variable, "t");
  const ReadStudy read = read_study(sharp);
  EXPECT_EQ(read.axes.front().lower, -1e6);
  EXPECT_EQ(read.axes.front().upper, 0);
  const PeakVariable variable = peak_variable(lobe("1e6"));
  EXPECT_EQ(variable.cosine_at(-1).one_minus_cos, 1e-6);
  EXPECT_EQ(variable.value_at({1 - 1e-6, 1e-6}), -1);
  EXPECT_EQ(in_cosines(variable, "no value at t = -500000"), "no value at c = 0.5");
  EXPECT_EQ(near_peak(lobe("1")).over.front().variable, "c") << "a blunt lobe";
}

// int_0^1 (c^k - exp((k + x)(c - 1))) (c - 1) exp(..) dc = 0 has x = 3/4 + 13/64/k + .. (approx/lobe.hpp). In
// c itself a double has no digit of the curve that is 1e-9 wide.
TEST(NearPeak, KeepsTheDigitsOfAVerySharpLobe) {
  const StudyFit fit = fit_study({.study = lobe("1e9")});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_NEAR(fit.parameters[0], 0.75 + 13.0 / 64 / 1e9, 1e-12);
  EXPECT_LE(fit.max_abs_error.at.front(), 1) << "a place is a cosine";
  EXPECT_GE(fit.max_abs_error.at.front(), 1 - 1e-8);
}

// The same integral by two ways: over t by dt, and over c by its density.
TEST(NearPeak, DensitiesKeepTheirMeaning) {
  for (const std::string& density : {density_of("angle", "c"), std::string("c"), std::string("1 + c^2")}) {
    Study plain = lobe("3", density);
    plain.near_peak = {};
    const StudyFit expected = fit_study({.study = plain}), fit = fit_study({.study = lobe("3", density)});
    ASSERT_EQ(fit.status, Status::converged) << fit.why;
    EXPECT_NEAR(fit.parameters[0], expected.parameters[0], 1e-12) << density;
    EXPECT_NEAR(fit.rms_error / expected.rms_error, 1, 1e-11) << density;
  }
}

TEST(NearPeak, ALobeBelowAnyDoubleIsNowhereVisible) {
  EXPECT_FALSE(where_lobe_is_visible(0.0077));
  EXPECT_NEAR(std::pow(where_lobe_is_visible(5)->cos_theta, 5), 1.0 / 255, 1e-17);
}

// Starts that lead to two optima are no answer: the basins are searched.
TEST(KnownStarts, ThatDisagreeBeginASearch) {
  Study study{.target = "sin(12 x)", .form = "b sin(a x)", .over = {{"x", "0", "3"}}};
  study.known_starts = {{{"b", 1}, {"a", 11}}, {{"b", 0.1}, {"a", 3}}};
  const StudyFit fit = fit_study({.study = study});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_NEAR(std::abs(fit.parameters[1]), 12, 1e-9);
  study.known_starts.pop_back();
  EXPECT_EQ(fit_study({.study = study}).starts, 1);
}

}  // namespace
}  // namespace shadefit
