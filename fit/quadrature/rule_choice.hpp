#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/substitution.hpp"

/// How many nodes a fit needs.
namespace shadefit {

/// The Gauss rules on which fits are polished and checked. Of two neighbours that agree the larger one is off
/// by a fraction of their difference: from one to the next the error of an entire integrand falls by 1e3 and
/// more, of one that converges like n^-16, the slowest that a substitution leaves, by 9 and more.
inline constexpr std::array<unsigned, 10> fit_rules{14, 18, 22, 26, 30, 38, 56, 84, 126, 190};

/// The smallest rule (an index of `fit_rules`) that can be expected to have converged to 1e-15 of a
/// parameter. It only saves time: whether the rules have converged is what the check of a fit finds out.
///
/// A concentrated and otherwise smooth integrand is a smooth factor times exp(-decline s) on [0, 1]; its
/// Gauss error falls faster than any power of the size once that exceeds decline / 4. How large it has to be
/// was measured, on Gaussian fits, whose Blinn counterparts need less: up to these declines the Newton step
/// of a rule at the optimum is 1e-15 at most. Of any other integrand nothing is known, and 26 nodes are the
/// middle.
inline std::size_t first_rule(const Metric& metric, const Shape& shape) {
  constexpr std::array most_decline{10.0, 20.0, 32.0, 48.0};
  constexpr std::size_t middle = 3;
  static_assert(fit_rules[middle] == 26);
  const double whole_decline = shape.concentration * (metric.domain.upper - metric.domain.lower);
  const bool is_cut = whole_decline > Substitution::decay;
  const bool is_smooth = is_cut || shape.end_power == std::floor(shape.end_power);
  if (shape.concentration == 0 || shape.joint || !shape.edges.empty() || !is_smooth) return middle;
  // In the angle exp(-decline y) is the bell exp(-decline theta^2 / 2), as hard as a decline of 15 more.
  const double decline =
      std::min(whole_decline, Substitution::decay) + (metric.measure == Measure::angle ? 15 : 0);
  const auto found =
      std::find_if(most_decline.begin(), most_decline.end(), [&](double most) { return decline <= most; });
  return static_cast<std::size_t>(found - most_decline.begin());
}

}  // namespace shadefit
