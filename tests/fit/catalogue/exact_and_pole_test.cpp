#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "fit/catalogue/family.hpp"

namespace shadefit {
namespace {

const Family& rational() {
  return *find_family("fresnel-rational");
}

// The pole at c = 0.5 has no width that a search could see: 1 + a c is 0 between any two of its places.
TEST(Pole, AnErrorWithAPoleIsInfinite) {
  const std::array a{-2.0};
  const Extremum absolute = rational().largest_error({}, {}, a),
                 relative = rational().largest_error({}, {.error = Error::relative}, a);
  EXPECT_EQ(absolute.magnitude, HUGE_VAL);
  EXPECT_EQ(relative.magnitude, HUGE_VAL);
  EXPECT_DOUBLE_EQ(absolute.at.cos_theta, 0.5);
  EXPECT_LT(rational().largest_error({}, {.domain = {0, 0.4}}, a).magnitude, 10);
}

void expect_border(const Surface& surface, const Metric& metric) {
  const Fit fit = rational().fit({0, surface}, metric);
  const std::string what = std::string(name(metric.norm)) + " at n = " + to_text(surface.ior);
  EXPECT_EQ(fit.status, Status::at_border) << what << ": a = " << fit.parameters[0];
  EXPECT_NE(fit.why.find("the way down leads to a pole of the form, at c = 0.9"), std::string::npos)
      << what << ": " << fit.why;
}

// From inside, and on this metal, the target stays above (1 - c)^3, which the form approaches from below as a
// falls to -1: the error falls all the way, and at -1 the form is 0/0 at c = 1.
TEST(Pole, AnOptimumAtTheBorderIsNoAnswer) {
  expect_border(exact_surface(0.476, 1.52), {.norm = Norm::minimax});
  for (const double ior : {0.485, 0.917}) expect_border(exact_surface(ior), {});
  expect_border(exact_surface(0.917), {.norm = Norm::minimax});
}

// On a domain that ends before c = 1 the pole at the border has a residue: the error grows without bound
// there.
TEST(Pole, NearTheBorderTheOptimumIsFound) {
  for (const double ior : {0.485, 0.7, 0.917}) {
    const Metric metric{.norm = Norm::minimax, .domain = {0, 0.8}};
    const Fit fit = rational().fit({0, exact_surface(ior)}, metric);
    ASSERT_EQ(fit.status, Status::converged) << ior << ": " << fit.why;
    EXPECT_GT(fit.parameters[0], -1.25) << ior;
    for (const double share : {0.999, 1.001}) {
      const std::array beside{-1.25 + share * (fit.parameters[0] + 1.25)};
      EXPECT_GT(rational().largest_error({0, exact_surface(ior)}, metric, beside).magnitude,
                fit.level.value())
          << ior;
    }
  }
}

// Near c = 1 an exact reflectance falls like (1 - c)^2, every form below (1 - c)^3.
TEST(Pole, AConstraintThatOnlyAPoleMeets) {
  const Fit fit = rational().fit({0, exact_surface(1.5)},
                                 {.norm = Norm::minimax, .constraints = {.one_sided = Side::above}});
  EXPECT_EQ(fit.status, Status::at_border) << fit.why;
}

// rms <= max of one error; the search and the quadrature are each other's check.
TEST(Errors, TheRootMeanSquareIsNeverAboveTheLargest) {
  EXPECT_EQ(contradiction_of(0.1, 0.2), "");
  EXPECT_EQ(contradiction_of(0.2, 0.2), "");
  EXPECT_EQ(contradiction_of(1e-16, 0), "") << "rounding";
  EXPECT_EQ(contradiction_of(0.02, HUGE_VAL), "the largest error is infinite");
  const std::string why = contradiction_of(4.995, 0.2766);
  EXPECT_NE(why.find("4.995"), std::string::npos) << why;
  EXPECT_NE(why.find("0.2766"), std::string::npos) << why;
  EXPECT_NE(contradiction_of(0.2000001, 0.2), "");
}

// Below the critical cosine all is reflected: the target is 1 = exp2(0).
TEST(ExactFit, TotalReflectionIsMetByZeros) {
  const Setting setting{0, exact_surface(0.853)};
  for (const char* id : {"fresnel-one-term", "fresnel-quadratic", "fresnel-cubic", "fresnel-quartic"}) {
    for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
      for (const Error error : {Error::absolute, Error::relative}) {
        const Fit fit = find_family(id)->fit(setting, {.norm = norm, .error = error, .domain = {0, 0.298}});
        ASSERT_EQ(fit.status, Status::converged) << id << ": " << fit.why;
        for (const double p : fit.parameters) EXPECT_EQ(p, 0) << id;
        EXPECT_EQ(fit.rms_error, 0) << id;
        EXPECT_EQ(fit.max_abs_error.magnitude, 0) << id;
        EXPECT_TRUE(fit.alternation.empty()) << id;
        EXPECT_EQ(fit.level, norm == Norm::minimax ? std::optional(0.0) : std::nullopt) << id;
      }
    }
  }
}

// (1-c)^5 rounds to 1 on a domain of length 1e-300, and yet it falls: exp2(0) is not it.
TEST(ExactFit, IsNotARoundedOne) {
  for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
    const Fit fit = find_family("fresnel-one-term")->fit({}, {.norm = norm, .domain = {0, 1e-300}});
    EXPECT_TRUE(fit.status != Status::converged || fit.parameters[0] > 7) << fit.parameters[0];
  }
}

// A bound that the exact form breaks binds all the same; a given parameter that is not 0 leaves an error.
TEST(ExactFit, KeepsToWhatIsAsked) {
  const Setting setting{0, exact_surface(0.853)};
  Metric metric{.norm = Norm::minimax, .domain = {0.1, 0.298}, .constraints = {.at_most = 0.9}};
  const Fit bounded = find_family("fresnel-one-term")->fit(setting, metric);
  ASSERT_EQ(bounded.status, Status::converged) << bounded.why;
  EXPECT_GT(bounded.level.value(), 0.09);
  metric.constraints = {.held = {{"a", 1}}};
  const Fit held = find_family("fresnel-quadratic")->fit(setting, metric);
  ASSERT_EQ(held.status, Status::converged) << held.why;
  EXPECT_GT(held.level.value(), 1e-4);
}

// Just above the critical cosine the target falls like a square root. A converged fit alternates beyond
// rounding; the others say why they did not converge.
TEST(ExactFit, NextToTheCriticalAngleNothingIsInvented) {
  const double critical = std::sqrt((1 - 0.853) * (1 + 0.853));
  for (const double beyond : {1e-16, 1e-14, 1e-12, 1e-9, 1e-6}) {
    for (const char* id : {"fresnel-one-term", "fresnel-quadratic"}) {
      const Fit fit = find_family(id)->fit({0, exact_surface(0.853)},
                                           {.norm = Norm::minimax, .domain = {0, critical + beyond}});
      if (fit.status != Status::converged) {
        EXPECT_NE(fit.why, "") << id << " " << beyond;
        continue;
      }
      for (const AlternationPoint& point : fit.alternation)
        EXPECT_NEAR(std::abs(point.error), fit.level.value(), 1e-3 * fit.level.value())
            << id << " " << beyond;
      EXPECT_EQ(fit.level.value() == 0, fit.alternation.empty()) << id << " " << beyond;
    }
  }
}

}  // namespace
}  // namespace shadefit
