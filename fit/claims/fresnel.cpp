#include "approx/fresnel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/ledger/formats.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit {
namespace {

/// In half arithmetic, how many pairs of f0 and g have F above max(g, f0) at c = 0, where the weight is 1,
/// and the largest excess in ulps.
std::pair<int, double> excess_in_half(int steps) {
  int pairs = 0;
  double ulps = 0;
  const auto grey = [&](int i) { return round_to_half(static_cast<double>(i) / steps); };
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const Eigen::half f0 = grey(i), gloss = grey(j), top = max(gloss, f0);
      const double above =
          widened(schlick_reflectance_of_gloss(f0, gloss, integer<Eigen::half>(1))) - widened(top);
      pairs += above > 0 ? 1 : 0;
      ulps = std::max(ulps, above / ulp_of_half(widened(top)));
    }
  }
  return {pairs, ulps};
}

Finding roughness_range(const Claim& claim) {
  const int steps = static_cast<int>(std::lround(given(claim, "steps")));
  const double highest = schlick_weight(given(claim, "from")), lowest = schlick_weight(given(claim, "to"));
  double outside = 0;  // the distance of F from its range
  int pairs = 0, flat = 0;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j, ++pairs) {
      const double f0 = static_cast<double>(i) / steps, gloss = static_cast<double>(j) / steps;
      flat += j <= i ? 1 : 0;
      for (const double weight : {lowest, highest}) {
        const double f = schlick_reflectance_of_gloss(f0, gloss, weight);
        outside = std::max({outside, f0 - f, f - max(gloss, f0)});
      }
    }
  }
  // Three operations on numbers of at most 1, each rounded by at most half an epsilon.
  const double rounding = 1.5 * std::numeric_limits<double>::epsilon();
  const auto [half_pairs, half_ulps] = excess_in_half(steps);
  return told(claim, verdict_of(outside <= rounding), "none", Told{"pairs", pairs},
              Told{"stays", outside <= rounding ? "stays within" : fmt::format("leaves by {:.4g}", outside)},
              Told{"rounding", rounding}, Told{"flat", flat}, Told{"half_pairs", half_pairs},
              Told{"half_ulps", half_ulps});
}

}  // namespace

std::vector<Evaluator> fresnel_evaluators() {
  return {{"fresnel-roughness", roughness_range}};
}

}  // namespace shadefit
