#pragma once

#include "approx/full_range.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of the forms that hold for every argument.
template <class Visit>
void full_range_formulas(const Visit& visit) {
  using Rows = Arguments;
  visit(Formula{"power_lobe_of_dot", [](auto c, auto k) { return power_lobe_of_dot(c, k); },
                Rows{{"0.875", "5"}}, 16});
  visit(Formula{"power_by_exp2_of_dot", [](auto c, auto k) { return power_by_exp2_of_dot(c, k); },
                Rows{{"0.875", "5"}}, 16});
  visit(Formula{"gaussian_lobe_base_two_of_dot",
                [](auto c, auto a) { return gaussian_lobe_base_two_of_dot(c, a); }, Rows{{"0.75", "7"}}, 16});
  visit(
      Formula{"schlick_weight_of_dot", [](auto c) { return schlick_weight_of_dot(c); }, Rows{{"0.25"}}, 16});
  visit(Formula{"decode_clamped_gloss", [](auto g, auto d, auto f) { return decode_clamped_gloss(g, d, f); },
                Rows{{"0.25", "10", "1"}}, 16});
  visit(Formula{"von_mises_fisher_of_any_concentration",
                [](auto y, auto k) { return von_mises_fisher_of_any_concentration(y, k); },
                Rows{{"0.25", "5"}, {"1.5", "0.125"}}, 32});
  visit(Formula{"henyey_greenstein_from_both_sides",
                [](auto y, auto g) { return henyey_greenstein_from_both_sides(y, g); },
                Rows{{"0.25", "0.75"}, {"1.5", "-0.5"}}, 32});
  visit(Formula{"blinn_phong_brdf_constant_by_parts",
                [](auto a) { return blinn_phong_brdf_constant_by_parts(a); }, Rows{{"8"}}, 32});
}

}  // namespace shadefit::testing
