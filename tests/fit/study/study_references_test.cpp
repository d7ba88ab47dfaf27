#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "fit/squares/solve_study.hpp"
#include "fit/study/study.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

namespace shadefit {
namespace {

/// The studies of tests/references/studies.csv as their users write them.
std::map<std::string, Study> studies() {
  const std::string line_over_line = "(a + b x)/(1 + d x)";
  return {
      {"kink", {.target = "abs(x - 0.3)", .form = "a + b x + d x^2", .over = {{"x", "0", "1"}}}},
      {"ramp", {.target = "max(x, 0)", .form = "a exp(b x)", .over = {{"x", "-1", "1"}}}},
      {"root", {.target = "sqrt(x)", .form = line_over_line, .over = {{"x", "0", "1"}}}},
      {"logarithm", {.target = "log(x)", .form = "a + b sqrt(x) + d x", .over = {{"x", "0", "1"}}}},
      {"chebyshev-density",
       {.target = "exp(-2 x^2)", .form = "a + b x^2 + d x^4", .over = {{"x", "-1", "1", "1/sqrt(1 - x^2)"}}}},
      {"two-bumps",
       {.target = "exp(-8 (x - 0.2)^2) + 0.9 exp(-30 (x - 1)^2)",
        .form = "a/(1 + b (x - d)^2)",
        .over = {{"x", "-1", "2"}}}},
      {"wave", {.target = "sin(7 x)", .form = "(a + b x)/(1 + d x + g x^2)", .over = {{"x", "0", "1"}}}},
      {"exponentials",
       {.target = "1/(1 + x)^2", .form = "a exp(-b x) + d exp(-g x)", .over = {{"x", "0", "4"}}}},
      {"srgb",
       {.target = "x <= 0.04045 ? x/12.92 : pow((x + 0.055)/1.055, 2.4)",
        .form = "x (a + x (b + d x))",
        .over = {{"x", "0", "1"}}}},
      {"tone-curve",
       {.target = "1 - exp(-x)", .form = "x (a x + b)/(x (d x + g) + 1)", .over = {{"x", "0", "8"}}}},
      {"arc-tangent", {.target = "atan(x)", .form = "x (a + b x^2)/(1 + d x^2)", .over = {{"x", "-1", "1"}}}},
      {"sine", {.target = "sin(x)", .form = "x (a + b x^2 + d x^4)", .over = {{"x", "-pi/2", "pi/2"}}}},
      {"cosine",
       {.target = "cos(x)", .form = "(1 + a x^2)/(1 + b x^2 + d x^4)", .over = {{"x", "-pi/2", "pi/2"}}}},
      {"relative",
       {.target = "exp(-3 x)", .form = line_over_line, .over = {{"x", "0", "1"}}, .error = Error::relative}},
      {"weighted",
       {.target = "exp(x) - 1", .form = "a x/(1 + b x)", .over = {{"x", "0", "2"}}, .weight = "x (2 - x)"}},
      {"integral",
       {.target = "integral(1/(1 + x t^2), t, 0, 1)", .form = line_over_line, .over = {{"x", "0", "1"}}}},
      {"plane",
       {.target = "exp(-x y)",
        .form = "a + b x + d y + g x y + h (x y)^2",
        .over = {{"x", "0", "1"}, {"y", "0", "2"}}}},
      {"plane-rational",
       {.target = "exp(-x - y/2) + x y/2",
        .form = "(a + b x + d y + g x y)/(1 + h x + k y + m x y + n x^2)",
        .over = {{"x", "0", "1"}, {"y", "0", "1"}}}},
      {"solid",
       {.target = "exp(-x y z) + x/2",
        .form = "(a + b x + d y z)/(1 + g x y z)",
        .over = {{"x", "0", "1"}, {"y", "0", "1"}, {"z", "0", "1/2"}}}},
  };
}

/// The reference values of each study: its parameters, `rms` and `largest`.
std::map<std::string, std::map<std::string, long double>> references() {
  std::map<std::string, std::map<std::string, long double>> result;
  const std::string path = SHADEFIT_SOURCE_DIR "/tests/references/studies.csv";
  for (const auto& row : parse_csv(read_file(path), "studies.csv").rows)
    result[row[0]][row[1]] = std::stold(row[2]);
  return result;
}

void expect_near(double computed, long double expected, double tolerance, const std::string& what) {
  if (std::isinf(expected)) {
    EXPECT_EQ(computed, static_cast<double>(expected)) << what;
    return;
  }
  const auto error = static_cast<double>(std::abs((computed - expected) / expected));
  EXPECT_LE(error, tolerance) << what << ": expected " << to_text(static_cast<double>(expected))
                              << ", computed " << to_text(computed) << ", error/tolerance "
                              << error / tolerance;
}

/// Fits a study and compares everything.
void expect_references(const std::string& id, const Study& study,
                       const std::map<std::string, long double>& expected) {
  const StudyFit fit = solve_study(read_study(study), {});
  ASSERT_EQ(name(fit.status), "converged") << id << ": " << fit.why;
  ASSERT_EQ(fit.names.size() + 2, expected.size()) << id;
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    const std::string what = id + ", " + fit.names[i];
    ASSERT_TRUE(expected.contains(fit.names[i])) << what;
    expect_near(fit.parameters[i], expected.at(fit.names[i]), 1e-13, what);
    // Nothing wrong is called right.
    expect_near(fit.parameters[i], expected.at(fit.names[i]), std::pow(10.0, -fit.digits), what + ", digits");
  }
  // At an optimum the rms does not change with the parameters: it is as right as the integral.
  expect_near(fit.rms_error, expected.at("rms"), 1e-13, id + ", rms error");
  // A difference form - target: its rounding is that of numbers of size 1 over an error of 1e-4.
  expect_near(fit.max_abs_error.magnitude, expected.at("largest"), 1e-11, id + ", largest error");
}

// Made without our code by tests/references/make_study_references.py, with the search for the best basin.
TEST(StudyReferences, HoldToThirteenDigits) {
  const auto all = studies();
  const auto expected = references();
  ASSERT_EQ(all.size(), expected.size());
  for (const auto& [id, study] : all) {
    ASSERT_TRUE(expected.contains(id)) << id << " has no reference";
    expect_references(id, study, expected.at(id));
  }
}

// The same studies with x in units of 1e-6, or with values in units of 1e9: the references with these units.
TEST(StudyReferences, AreTheSameInOtherUnits) {
  struct InUnits {
    std::string id;
    Study study;
    std::map<std::string, double> factors;
  };
  const std::vector<InUnits> studies{
      {"exponentials",
       {.target = "1/(1 + x/1e6)^2", .form = "a exp(-b x) + d exp(-g x)", .over = {{"x", "0", "4e6"}}},
       {{"b", 1e-6}, {"g", 1e-6}}},
      {"exponentials",
       {.target = "1e-9/(1 + x)^2", .form = "a exp(-b x) + d exp(-g x)", .over = {{"x", "0", "4"}}},
       {{"a", 1e-9}, {"d", 1e-9}}},
      {"two-bumps",
       {.target = "exp(-8 (x/1e6 - 0.2)^2) + 0.9 exp(-30 (x/1e6 - 1)^2)",
        .form = "a/(1 + b (x - d)^2)",
        .over = {{"x", "-1e6", "2e6"}}},
       {{"b", 1e-12}, {"d", 1e6}}},
      {"tone-curve",
       {.target = "1 - exp(-1e5 x)", .form = "x (a x + b)/(x (d x + g) + 1)", .over = {{"x", "0", "8e-5"}}},
       {{"a", 1e10}, {"b", 1e5}, {"d", 1e10}, {"g", 1e5}}},
  };
  const auto expected = references();
  for (const auto& [id, study, factors] : studies) {
    const StudyFit fit = solve_study(read_study(study), {});
    ASSERT_EQ(name(fit.status), "converged") << id << ": " << fit.why;
    for (std::size_t i = 0; i < fit.names.size(); ++i) {
      const auto factor = factors.find(fit.names[i]);
      const auto unit = static_cast<long double>(factor == factors.end() ? 1 : factor->second);
      expect_near(fit.parameters[i], expected.at(id).at(fit.names[i]) * unit, 1e-13,
                  id + " in other units, " + fit.names[i]);
    }
  }
}

}  // namespace
}  // namespace shadefit
