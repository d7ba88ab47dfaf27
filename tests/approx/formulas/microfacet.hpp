#pragma once

#include <tuple>

#include "approx/microfacet.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of microfacets.
inline auto microfacet_formulas() {
  using Lobes = Arguments;
  // cos^2 of the angle between m and n, and alpha; 1 is the limit of GTR1
  const Lobes microfacets{{"0.75", "0.5"}, {"0.25", "0.75"}, {"0.5", "1"}};
  return std::tuple{
      Formula{"erfc", [](auto x) { return erfc(x); }, Lobes{{"-0.5"}, {"0"}, {"1.5"}}, 16},
      Formula{"blinn_phong_exponent", [](auto a) { return blinn_phong_exponent(a); },
              Lobes{{"0.5"}, {"0.75"}}, 8},
      Formula{"blinn_phong_distribution",
              [](auto c, auto a) { return blinn_phong_distribution(normal_of(c), a); }, microfacets, 32},
      Formula{"beckmann_distribution", [](auto c, auto a) { return beckmann_distribution(normal_of(c), a); },
              microfacets, 32},
      Formula{"ggx_distribution", [](auto c, auto a) { return ggx_distribution(normal_of(c), a); },
              microfacets, 16},
      Formula{"gtr1_distribution", [](auto c, auto a) { return gtr1_distribution(normal_of(c), a); },
              microfacets, 16},
      Formula{"beckmann_lambda", [](auto s) { return beckmann_lambda(s); }, Lobes{{"0.5"}, {"4"}}, 128},
      Formula{"ggx_lambda", [](auto s) { return ggx_lambda(s); }, Lobes{{"0.0625"}, {"0.5"}, {"4"}}, 16},
      Formula{"smith_masking", [](auto l) { return smith_masking(l); }, Lobes{{"0.5"}}, 4},
      Formula{"facing_circle",
              [](auto view, auto normal, auto phi) {
                return facing_circle(direction_of(view), direction_of(normal), arc_to(phi));
              },
              Lobes{{"0.5", "0.25", "3"}, {"1", "1", "2"}}, 16},
  };
}

}  // namespace shadefit::testing
