#pragma once

#include <set>
#include <string>

#include "fit/scalars/symbolic.hpp"

/// Integrals inside a formula.
namespace shadefit {

/// The rules by which an integral is computed: `usual`, and a larger one that tells how many digits are
/// right.
enum class IntegralRule { usual, check };

/// How many values of its body an integral takes by the usual rule.
inline constexpr std::size_t integral_nodes = 75;

/// The sum that stands for an integral: (upper - lower) times weighted values of its body.
///
/// The rule is the double-exponential one: with s = 1/(1 + exp(-pi sinh u)) it is the trapezoidal rule in u,
/// of step 1/12 or 1/16, where s is at least 2^-50 from both ends. The weights are scaled to the sum 1. It
/// has 14 digits for integrands that are analytic inside, with roots and logarithms at the ends; 7 for
/// 1/sqrt(t). Source: Takahasi, Mori 1974, "Double exponential formulas for numerical integration",
/// Publications of the Research Institute for Mathematical Sciences 9.
Symbolic summed(const Symbolic& integral, IntegralRule rule);

/// The variables of a formula, without those that its integrals run over.
std::set<std::string> free_variables(const Symbolic& formula);

/// Whether one of these names is a free variable of a formula.
bool contains_any(const Symbolic& formula, const std::vector<std::string>& names);

/// How many integrals are inside one another; 0 for a formula without one. An albedo is a double integral.
int integral_depth(const Symbolic& formula);

}  // namespace shadefit
