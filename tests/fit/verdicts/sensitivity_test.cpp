#include "fit/verdicts/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

const Metric minimax{.norm = Norm::minimax};

Fit fitted(std::string_view id, const Metric& metric = {}, double exponent = 0) {
  const Fit fit = find_family(id)->fit(exponent, metric);
  EXPECT_EQ(fit.status, Status::converged) << id << " " << fit.why;
  return fit;
}

/// The fits that the invariants are checked on: one to four parameters, both norms, a weight, a lobe.
std::vector<Fit> samples() {
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

double objective_of(const Fit& fit, const std::vector<double>& parameters) {
  return fit.family->objective(setting_of(fit), fit.metric)(parameters);
}

std::string what(const Fit& fit, std::string_view parameter) {
  return std::string(fit.family->id) + " " + std::string(parameter) + ", " + describe(fit.metric);
}

/// The least objective with one parameter given, by a refit of the public kind.
double refitted(const Fit& fit, std::size_t i, double value) {
  const Family& family = *fit.family;
  if (family.parameters.size() == 1) return objective_of(fit, {value});
  Metric metric = fit.metric;
  metric.constraints.held = {{std::string(family.parameters[i]), value}};
  const Fit held = family.fit(setting_of(fit), metric);
  EXPECT_EQ(held.status, Status::converged) << held.why;
  return metric.norm == Norm::minimax ? *held.level : held.rms_error;
}

// An end is found to 30 bits of its step, so the objective there is the limit to about 1e-10 of itself.
TEST(Sensitivity, AtTheEndsOfAProfileTheObjectiveIsWorseByOnePercent) {
  for (const Fit& fit : samples()) {
    const Sensitivity found = sensitivity_of(fit);
    EXPECT_NEAR(found.objective / objective_of(fit, fit.parameters), 1, 1e-14);
    EXPECT_EQ(found.parameters.size(), fit.parameters.size());
    for (std::size_t i = 0; i < found.parameters.size(); ++i) {
      const ParameterSensitivity& p = found.parameters[i];
      ASSERT_TRUE(p.lower && p.upper) << what(fit, p.parameter);
      EXPECT_LT(*p.lower, p.value);
      EXPECT_GT(*p.upper, p.value);
      EXPECT_NEAR(refitted(fit, i, *p.lower) / found.objective, 1.01, 1e-8) << what(fit, p.parameter);
      EXPECT_NEAR(refitted(fit, i, *p.upper) / found.objective, 1.01, 1e-8) << what(fit, p.parameter);
      EXPECT_LT(refitted(fit, i, (*p.lower + p.value) / 2) / found.objective, 1.01) << what(fit, p.parameter);
      EXPECT_LT(refitted(fit, i, (*p.upper + p.value) / 2) / found.objective, 1.01) << what(fit, p.parameter);
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
  for (const Fit& fit : samples()) {
    const Sensitivity found = sensitivity_of(fit);
    for (std::size_t i = 0; i < found.parameters.size(); ++i) {
      const ParameterSensitivity& p = found.parameters[i];
      for (const auto& [text, part] :
           {std::pair(p.noticeable_digits, noticeable), std::pair(p.slight_digits, slight)}) {
        const double limit = found.objective * (1 + part);
        const auto with = [&](double value) {
          auto parameters = fit.parameters;
          parameters[i] = value;
          return objective_of(fit, parameters);
        };
        EXPECT_LE(with(*parse_number(text)), limit) << what(fit, p.parameter) << " " << text;
        const int digits = digits_of(text);
        if (digits == 1) continue;
        for (const double shorter : both_neighbours(p.value, digits - 1))
          EXPECT_GT(with(shorter), limit) << what(fit, p.parameter) << " " << text << " or " << shorter;
      }
    }
  }
}

TEST(Sensitivity, AllConstantsTogether) {
  for (const Fit& fit : samples()) {
    const Sensitivity found = sensitivity_of(fit);
    for (const auto& [common, part] :
         {std::pair(found.noticeable_digits, noticeable), std::pair(found.slight_digits, slight)}) {
      ASSERT_TRUE(common);
      std::vector<double> parameters, shorter;
      for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        parameters.push_back(*parse_number(common->parameters[i]));
        EXPECT_EQ(parameters[i], *parse_number(decimal(fit.parameters[i], common->digits)));
        shorter.push_back(*parse_number(decimal(fit.parameters[i], std::max(1, common->digits - 1))));
      }
      EXPECT_EQ(common->objective, objective_of(fit, parameters));
      EXPECT_LE(common->objective, found.objective * (1 + part));
      EXPECT_TRUE(common->digits == 1 || objective_of(fit, shorter) > found.objective * (1 + part));
    }
  }
}

// s (1-c)^4 is linear in s: the square of its rms error is I(s) = s^2/9 - 2 s/10 + 1/11, the integrals of
// (1-c)^8, (1-c)^9 and (1-c)^10. The optimum is s = 9/10, I there 1/1100, and it is 1.01^2 of that at
// s = 9/10 +- 3 sqrt((1.01^2 - 1)/1100).
TEST(Sensitivity, AgreesWithTheClosedFormOfALinearFamily) {
  const Fit fit = fitted("fresnel-fourth");
  EXPECT_NEAR(fit.parameters[0], 0.9, 1e-14);
  const Sensitivity found = sensitivity_of(fit);
  EXPECT_NEAR(found.objective, std::sqrt(1.0 / 1100), 1e-15);
  const double reach = 3 * std::sqrt((1.01 * 1.01 - 1) / 1100);
  EXPECT_NEAR(*found.parameters[0].lower, 0.9 - reach, 1e-9);
  EXPECT_NEAR(*found.parameters[0].upper, 0.9 + reach, 1e-9);
  EXPECT_EQ(found.parameters[0].slight_digits, "0.9");
}

// exp2(-A c) by brute force over decimals in steps of the last digit.
TEST(Sensitivity, AgreesWithBruteForceOnOneParameter) {
  const Fit fit = fitted("fresnel-one-term", minimax);
  const Sensitivity found = sensitivity_of(fit);
  const auto is_within = [&](double a, double part) {
    return objective_of(fit, {a}) <= found.objective * (1 + part);
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
  const Fit fit = fitted("fresnel-quadratic", metric);
  const Sensitivity found = sensitivity_of(fit);
  ASSERT_EQ(found.parameters.size(), 1U);
  EXPECT_EQ(found.parameters[0].parameter, "a");
  EXPECT_EQ(found.noticeable_digits->parameters[1], "-6.98765");
  EXPECT_NEAR(objective_of(fit, {*found.parameters[0].upper, -6.98765}) / found.objective, 1.01, 1e-8);
}

// With A given above its optimum the largest error is A - 1, at c = 1, whatever the offset is: no refit can
// say which offset is best, and the interval has no such end.
TEST(Sensitivity, AnEndWhereARefitFailsIsEmpty) {
  const Fit fit = fitted("sg-scaled", minimax, 37.5);
  Metric held = minimax;
  held.constraints.held = {{"A", fit.parameters[0] * 1.0001}};
  EXPECT_NE(find_family("sg-scaled")->fit(37.5, held).status, Status::converged);
  EXPECT_FALSE(sensitivity_of(fit).parameters[0].upper);
}

TEST(Sensitivity, OtherContractsAreFitsOfTheirOwn) {
  const Fit fit = fitted("fresnel-quadratic");
  const Sensitivity found = sensitivity_of(fit);
  ASSERT_EQ(found.contracts.size(), 6U) << "three measures, three domains";
  EXPECT_EQ(found.contracts.front().metric, fit.metric);
  EXPECT_EQ(found.contracts.front().fit.parameters, fit.parameters);
  for (std::size_t i = 1; i < found.contracts.size(); ++i) {
    const auto& [metric, other] = found.contracts[i];
    EXPECT_NE(metric, fit.metric);
    EXPECT_EQ(other.parameters, find_family("fresnel-quadratic")->fit({}, metric).parameters);
  }
  EXPECT_EQ(found.contracts.back().metric.domain, (Domain{0.1, 0.9}));
  EXPECT_EQ(sensitivity_of(fitted("fresnel-quadratic", minimax)).contracts.size(), 4U)
      << "minimax has no measure";
}

}  // namespace
}  // namespace shadefit
