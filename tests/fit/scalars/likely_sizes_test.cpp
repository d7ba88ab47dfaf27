#include "fit/scalars/likely_sizes.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fit/formula/parse_formula.hpp"

namespace shadefit {
namespace {

/// The sizes of the parameters of a form whose x is of the size 2^20, and whose value is of the size
/// 2^result.
std::vector<double> sizes_of(const std::string& form, const std::vector<std::string>& parameters,
                             double result) {
  FormulaNames names{.variables = parameters, .takes_integrals = true};
  names.variables.push_back("x");
  return likely_sizes(read_formula(form, names).formula, parameters, {{"x", 20}}, result);
}

void expect_sizes(const std::string& form, const std::vector<std::string>& parameters, double result,
                  const std::vector<double>& expected) {
  const std::vector<double> sizes = sizes_of(form, parameters, result);
  ASSERT_EQ(sizes.size(), expected.size()) << form;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    EXPECT_NEAR(sizes[i], expected[i], 1e-12) << form << ", " << parameters[i];
}

// What a physicist writes down for units.
TEST(LikelySizes, AreThoseOfUnits) {
  expect_sizes("exp(-a*x)", {"a"}, 0, {-20});
  expect_sizes("b*exp(-a*x)", {"b", "a"}, 7, {7, -20});
  expect_sizes("exp(-((x - b)/a)^2)", {"a", "b"}, 0, {20, 20});
  expect_sizes("1/(1 + a*x + b*x^2)", {"a", "b"}, 0, {-20, -40});
  expect_sizes("1/(a + b*x)", {"a", "b"}, 8, {-8, -28});
  expect_sizes("max(a*x, b)", {"a", "b"}, 0, {-20, 0});
  expect_sizes("sqrt(x^2 + a^2)", {"a"}, 20, {20});
  expect_sizes("x < a ? b*x : d", {"a", "b", "d"}, 0, {20, -20, 0});
  expect_sizes("(1 + a*x)^b", {"a", "b"}, 3, {-20, 0});
  expect_sizes("integral(exp(-a*t), t, 0, x)", {"a"}, 20, {-20});
  expect_sizes("64 + 0*a + exp(0.015625*b)", {"a", "b"}, 6, {0, 6});
}

}  // namespace
}  // namespace shadefit
