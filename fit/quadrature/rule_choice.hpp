#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/substitution.hpp"

/// The number of nodes that a fit needs.
namespace shadefit {

/// The Gauss rules on which fits are polished and checked. If two neighbours agree, the error of the larger
/// rule is a fraction of their difference. From one rule to the next, the error of an entire integrand falls
/// by a factor of at least 1e3. After a substitution the slowest convergence is like n^-16: a factor of at
/// least 9.
inline constexpr std::array<unsigned, 10> fit_rules{14, 18, 22, 26, 30, 38, 56, 84, 126, 190};

/// The smallest rule (an index of `fit_rules`) that has probably converged to 1e-15 of a parameter. The
/// choice only saves time: the check of a fit tells whether the rules have converged.
///
/// A concentrated and otherwise smooth integrand is a smooth factor times exp(-decline s) on [0, 1]; its
/// Gauss error falls faster than any power of the size once the size exceeds decline / 4. The sizes below
/// were measured on Gaussian fits (Phong-Blinn fits need less): up to these declines the Newton step of a
/// rule at the optimum is at most 1e-15. Nothing is known about other integrands; 26 nodes are in the middle.
inline std::size_t first_rule(const Metric& metric, const Shape& shape) {
  constexpr std::array most_decline{10.0, 20.0, 32.0, 48.0};
  constexpr std::size_t middle = 3;
  static_assert(fit_rules[middle] == 26);
  const double whole_decline = shape.concentration * (metric.domain.upper - metric.domain.lower);
  const bool is_cut = whole_decline > Substitution::decay;
  const bool is_smooth = is_cut || shape.end_power == std::floor(shape.end_power);
  if (shape.concentration == 0 || shape.joint || !shape.edges.empty() || !is_smooth) return middle;
  // In the angle, exp(-decline y) is the bell exp(-decline theta^2 / 2). It needs the nodes of a decline that
  // is larger by 15.
  const double decline =
      std::min(whole_decline, Substitution::decay) + (metric.measure == Measure::angle ? 15 : 0);
  const auto found =
      std::find_if(most_decline.begin(), most_decline.end(), [&](double most) { return decline <= most; });
  return static_cast<std::size_t>(found - most_decline.begin());
}

}  // namespace shadefit
