#pragma once

#include "approx/arithmetic.hpp"
#include "approx/cost.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of the forms whose instructions are counted.
template <class Visit>
void cost_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes lobes{{"0.875", "5"}, {"0.75", "8"}, {"0.5", "0.5"}};
  visit(Formula{"power_by_exp2", [](auto c, auto k) { return power_by_exp2(c, k); }, lobes, 16});
  visit(Formula{"gaussian_lobe_base_two_of_difference",
                [](auto c, auto a) { return gaussian_lobe_base_two_of_difference(c, a); }, lobes, 16});
  visit(Formula{"mip_level_of_successor", [](auto w, auto s) { return mip_level_of_successor(w, s); },
                Lobes{{"128", "8"}}, 16});
  visit(Formula{
      "phong_by_exp2",
      [](auto r, auto l, auto a) {
        using T = decltype(a);
        return phong_by_exp2(scaled_reflection(std::array<T, 3>{r, r, r}, a), std::array<T, 3>{l, l, r});
      },
      Lobes{{"0.5", "0.625", "8"}}, 16});
  visit(Formula{"phong_cosine",
                [](auto r, auto l, auto m) {
                  using T = decltype(m);
                  return phong_cosine(std::array<T, 3>{r, l, m}, std::array<T, 3>{l, l, m});
                },
                Lobes{{"0.5", "0.625", "0.25"}}, 8});
}

}  // namespace shadefit::testing
