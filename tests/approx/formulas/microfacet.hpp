#pragma once

#include "approx/microfacet.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of microfacets.
template <class Visit>
void microfacet_formulas(const Visit& visit) {
  using Lobes = Arguments;
  // cos^2 of the angle between m and n, and alpha; 1 is the limit of GTR1
  const Lobes microfacets{{"0.75", "0.5"}, {"0.25", "0.75"}, {"0.5", "1"}};
  visit(Formula{"erfc", [](auto x) { return erfc(x); }, Lobes{{"-0.5"}, {"0"}, {"1.5"}}, 16});
  visit(Formula{"blinn_phong_exponent", [](auto a) { return blinn_phong_exponent(a); },
                Lobes{{"0.5"}, {"0.75"}}, 8});
  visit(Formula{"blinn_phong_distribution",
                [](auto c, auto a) { return blinn_phong_distribution(normal_of(c), a); }, microfacets, 32});
  visit(Formula{"beckmann_distribution",
                [](auto c, auto a) { return beckmann_distribution(normal_of(c), a); }, microfacets, 32});
  visit(Formula{"ggx_distribution", [](auto c, auto a) { return ggx_distribution(normal_of(c), a); },
                microfacets, 16});
  visit(Formula{"gtr1_distribution", [](auto c, auto a) { return gtr1_distribution(normal_of(c), a); },
                microfacets, 16});
  visit(Formula{"beckmann_lambda", [](auto s) { return beckmann_lambda(s); }, Lobes{{"0.5"}, {"4"}}, 128});
  visit(Formula{"ggx_lambda", [](auto s) { return ggx_lambda(s); }, Lobes{{"0.0625"}, {"0.5"}, {"4"}}, 16});
  visit(Formula{"smith_masking", [](auto l) { return smith_masking(l); }, Lobes{{"0.5"}}, 4});
  visit(Formula{"facing_circle",
                [](auto view, auto normal, auto phi) {
                  return facing_circle(direction_of(view), direction_of(normal), arc_to(phi));
                },
                Lobes{{"0.5", "0.25", "3"}, {"1", "1", "2"}}, 16});
}

}  // namespace shadefit::testing
