#include "fit/verdicts/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/fit_study.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const Metric minimax{.norm = Norm::minimax};

/// A form of the catalogue, and its fit.
struct Fitted {
  std::string what;
  StudyObjective asked;
  StudyFit fit;
  std::function<double(const std::vector<double>&)> objective;
};

Fitted fitted(std::string_view id, const Metric& metric = {}, double exponent = 0) {
  const Family& family = *find_family(id);
  Fitted of{.what = std::string(id) + ", " + describe(metric), .asked = {}, .fit = {}, .objective = {}};
  of.asked = {.words = of.what, .study = study_of(family, exponent, metric).value(), .norm = metric.norm};
  of.fit = fit_study(of.asked);
  of.objective = [norm = metric.norm,
                  read = read_study(near_peak(of.asked.study))](const std::vector<double>& at) {
    return norm == Norm::minimax ? largest_weighted_error(read, at).magnitude
                                 : rms_error(read, StudyError(read), at);
  };
  EXPECT_EQ(of.fit.status, Status::converged) << id << " " << of.fit.why;
  return of;
}

Sensitivity sensitivity_of(const Fitted& of) {
  return sensitivity_of(of.asked, of.fit);
}

/// The fits that the invariants are checked on: one to four parameters, both norms, a weight, a lobe.
std::vector<Fitted> samples() {
  Metric weighted;
  weighted.weight = "1 + 4 c";
  Metric relative = minimax;
  relative.error = Error::relative;
  return {fitted("fresnel-one-term"),
          fitted("fresnel-one-term", minimax),
          fitted("fresnel-quadratic"),
          fitted("fresnel-quadratic", minimax),
          fitted("fresnel-quadratic", weighted),
          fitted("fresnel-quadratic", relative),
          fitted("fresnel-cubic"),
          fitted("fresnel-quartic", minimax),
          fitted("sg-offset", {}, 5),
          fitted("sg-scaled", {}, 37.5)};
}

/// The least objective with one parameter given, by a refit of the public kind.
double refitted(const Fitted& of, std::size_t i, double value) {
  if (of.fit.names.size() == 1) return of.objective({value});
  StudyObjective asked = of.asked;
  asked.study.held = {{of.fit.names[i], value}};
  const StudyFit held = fit_study(asked);
  EXPECT_EQ(held.status, Status::converged) << held.why;
  return held.level ? *held.level : held.rms_error;
}

// An end is found to 30 bits of its step, so the objective there is the limit to about 1e-10 of itself.
TEST(Sensitivity, AtTheEndsOfAProfileTheObjectiveIsWorseByOnePercent) {
  for (const Fitted& of : samples()) {
    const StudyFit& fit = of.fit;
    const Sensitivity found = sensitivity_of(of);
    EXPECT_NEAR(found.objective / of.objective(fit.parameters), 1, 1e-13);
    EXPECT_EQ(found.parameters.size(), fit.parameters.size());
    for (std::size_t i = 0; i < found.parameters.size(); ++i) {
      const ParameterSensitivity& p = found.parameters[i];
      ASSERT_TRUE(p.lower && p.upper) << of.what << " " << p.parameter;
      EXPECT_LT(*p.lower, p.value);
      EXPECT_GT(*p.upper, p.value);
      EXPECT_NEAR(refitted(of, i, *p.lower) / found.objective, 1.01, 1e-8) << of.what << " " << p.parameter;
      EXPECT_NEAR(refitted(of, i, *p.upper) / found.objective, 1.01, 1e-8) << of.what << " " << p.parameter;
      EXPECT_LT(refitted(of, i, (*p.lower + p.value) / 2) / found.objective, 1.01)
          << of.what << " " << p.parameter;
      EXPECT_LT(refitted(of, i, (*p.upper + p.value) / 2) / found.objective, 1.01)
          << of.what << " " << p.parameter;
    }
  }
}

/// Significant digits of a decimal text.
int digits_of(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if (c >= '0' && c <= '9') digits += c;
  }
  digits.erase(0, digits.find_first_not_of('0'));
  if (text.find('.') == std::string::npos) digits.erase(digits.find_last_not_of('0') + 1);
  return static_cast<int>(digits.size());
}

/// The decimals of so many digits next to a value on either side, by scaling: another way than the code's.
std::vector<double> both_neighbours(double value, int digits) {
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1 - digits;
  const long double unit = std::pow(10.0L, exponent);
  const long double count = std::floor(static_cast<long double>(value) / unit);
  return {static_cast<double>(count * unit), static_cast<double>((count + 1) * unit)};
}

TEST(Sensitivity, PrintedDecimalsKeepTheLimitAndOneDigitFewerDoesNot) {
  for (const Fitted& of : samples()) {
    const StudyFit& fit = of.fit;
    const Sensitivity found = sensitivity_of(of);
    for (std::size_t i = 0; i < found.parameters.size(); ++i) {
      const ParameterSensitivity& p = found.parameters[i];
      for (const auto& [text, part] :
           {std::pair(p.noticeable_digits, noticeable), std::pair(p.slight_digits, slight)}) {
        const double limit = found.objective * (1 + part);
        const auto with = [&](double value) {
          auto parameters = fit.parameters;
          parameters[i] = value;
          return of.objective(parameters);
        };
        EXPECT_LE(with(*parse_number(text)), limit) << of.what << " " << p.parameter << " " << text;
        const int digits = digits_of(text);
        if (digits == 1) continue;
        for (const double shorter : both_neighbours(p.value, digits - 1))
          EXPECT_GT(with(shorter), limit)
              << of.what << " " << p.parameter << " " << text << " or " << shorter;
      }
    }
  }
}

TEST(Sensitivity, AllConstantsTogether) {
  for (const Fitted& of : samples()) {
    const StudyFit& fit = of.fit;
    const Sensitivity found = sensitivity_of(of);
    for (const auto& [common, part] :
         {std::pair(found.noticeable_digits, noticeable), std::pair(found.slight_digits, slight)}) {
      ASSERT_TRUE(common);
      std::vector<double> parameters, shorter;
      for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        parameters.push_back(*parse_number(common->parameters[i]));
        EXPECT_EQ(parameters[i], *parse_number(decimal(fit.parameters[i], common->digits)));
        shorter.push_back(*parse_number(decimal(fit.parameters[i], std::max(1, common->digits - 1))));
      }
      EXPECT_NEAR(common->objective / of.objective(parameters), 1, 1e-13);
      EXPECT_LE(common->objective, found.objective * (1 + part));
      EXPECT_TRUE(common->digits == 1 || of.objective(shorter) > found.objective * (1 + part));
    }
  }
}

// s (1-c)^4 is linear in s: the square of its rms error is I(s) = s^2/9 - 2 s/10 + 1/11, the integrals of
// (1-c)^8, (1-c)^9 and (1-c)^10. The optimum is s = 9/10, I there 1/1100, and it is 1.01^2 of that at
// s = 9/10 +- 3 sqrt((1.01^2 - 1)/1100).
TEST(Sensitivity, AgreesWithTheClosedFormOfALinearFamily) {
  const Fitted of = fitted("fresnel-fourth");
  EXPECT_NEAR(of.fit.parameters[0], 0.9, 1e-14);
  const Sensitivity found = sensitivity_of(of);
  EXPECT_NEAR(found.objective, std::sqrt(1.0 / 1100), 1e-15);
  const double reach = 3 * std::sqrt((1.01 * 1.01 - 1) / 1100);
  EXPECT_NEAR(*found.parameters[0].lower, 0.9 - reach, 1e-9);
  EXPECT_NEAR(*found.parameters[0].upper, 0.9 + reach, 1e-9);
  EXPECT_EQ(found.parameters[0].slight_digits, "0.9");
}

// exp2(-A c) by brute force over decimals in steps of the last digit.
TEST(Sensitivity, AgreesWithBruteForceOnOneParameter) {
  const Fitted of = fitted("fresnel-one-term", minimax);
  const Sensitivity found = sensitivity_of(of);
  const auto is_within = [&](double a, double part) {
    return of.objective({a}) <= found.objective * (1 + part);
  };
  for (int a = 1; a <= 12; ++a) EXPECT_FALSE(is_within(a, noticeable)) << a;
  int tenths = 0, hundredths = 0;
  for (int a = 60; a <= 110; ++a) tenths += is_within(a / 10.0, noticeable);
  for (int a = 600; a <= 1100; ++a) hundredths += is_within(a / 100.0, noticeable);
  EXPECT_EQ(tenths, 0);
  EXPECT_GT(hundredths, 0);
  EXPECT_EQ(found.parameters[0].noticeable_digits, "8.25");
}

TEST(Sensitivity, WhatIsGivenStays) {
  Metric metric;
  metric.constraints.held = {{"b", -6.98765}};
  const Fitted of = fitted("fresnel-quadratic", metric);
  const Sensitivity found = sensitivity_of(of);
  ASSERT_EQ(found.parameters.size(), 1U);
  EXPECT_EQ(found.parameters[0].parameter, "a");
  EXPECT_EQ(found.noticeable_digits->parameters.size(), 1U);
  EXPECT_NEAR(of.objective({*found.parameters[0].upper}) / found.objective, 1.01, 1e-8);
}

// With A given above its optimum the largest error is A - 1, at c = 1, whatever the offset is: the profile is
// A - 1, and it reaches 1.01 of the level there.
TEST(Sensitivity, HasAnEndWhereAGivenPeakMakesTheError) {
  const Fitted of = fitted("sg-scaled", minimax, 37.5);
  const Sensitivity found = sensitivity_of(of);
  EXPECT_NEAR(found.parameters[0].upper.value(), 1 + 1.01 * of.fit.level.value(), 1e-9);
}

// |a| is the error at 0, so the held a alone makes the largest error: b is free there.
TEST(Sensitivity, HasAnEndWhereAHeldConstantMakesTheError) {
  const Study line{.target = "x^2", .form = "a + b x", .over = {{"x", "0", "1"}}};
  const StudyObjective asked = objective_of(line, Norm::minimax, {});
  const Sensitivity found = sensitivity_of(asked, fit_study(asked));
  EXPECT_NEAR(found.objective, 0.125, 1e-12);
  EXPECT_NEAR(found.parameters[0].lower.value(), -0.125 * 1.01, 1e-9);
  EXPECT_GT(found.parameters[0].upper.value(), -0.125);
}

TEST(Sensitivity, OtherFitsHaveOtherDensitiesAndRanges) {
  const Fitted of = fitted("fresnel-quadratic");
  const Sensitivity found = sensitivity_of(of);
  ASSERT_EQ(found.others.size(), 6U) << "three measures, three ranges";
  EXPECT_EQ(found.others.front().fit.parameters, of.fit.parameters);
  const std::vector<Metric> metrics{{.measure = Measure::angle},
                                    {.measure = Measure::cosine_weighted},
                                    {.domain = {0.1, 1}},
                                    {.domain = {0, 0.9}},
                                    {.domain = {0.1, 0.9}}};
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const Fit expected = find_family("fresnel-quadratic")->fit({}, metrics[i]);
    EXPECT_NEAR(found.others[i + 1].fit.parameters[0] / expected.parameters[0], 1, 1e-12)
        << found.others[i + 1].under;
  }
  EXPECT_EQ(sensitivity_of(fitted("fresnel-quadratic", minimax)).others.size(), 4U)
      << "minimax has no measure";
}

TEST(Sensitivity, RefusesConstraints) {
  const Study study{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};
  const StudyObjective asked = objective_of(study, Norm::minimax, {.exact_at = {0}});
  EXPECT_THROW(sensitivity_of(asked, fit_study(asked)), UserError);
}

TEST(Sensitivity, HasNoOtherFitsInTwoVariables) {
  const Study study{.target = "x y", .form = "a + b x", .over = {{"x", "0", "1"}, {"y", "0", "1"}}};
  const StudyObjective asked = objective_of(study, Norm::least_squares, {});
  const Sensitivity found = sensitivity_of(asked, fit_study(asked));
  EXPECT_EQ(found.parameters.size(), 2U);
  EXPECT_TRUE(found.others.empty());
}

}  // namespace
}  // namespace shadefit
