#pragma once

#include "approx/gloss.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of gloss.
template <class Visit>
void gloss_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{"decode_gloss", [](auto g, auto d, auto f) { return decode_gloss(g, d, f); },
                Lobes{{"0.25", "10", "1"}, {"0.875", "10", "1.5"}}, 16});
  visit(Formula{"base_two_power", [](auto k) { return base_two_power(k); }, Lobes{{"5"}}, 4});
  visit(Formula{"base_two_first", [](auto f) { return base_two_first(f); }, Lobes{{"1"}}, 4});
  visit(Formula{"gaussian_lobe_base_two", [](auto c, auto m) { return gaussian_lobe_base_two(c, m); },
                Lobes{{"0.75", "7"}}, 16});
  visit(Formula{"base_two_normalisation",
                [](auto m, auto b) {
                  return base_two_normalisation(m, base_two_normalisation_factor<decltype(m)>(), b);
                },
                Lobes{{"7", "0.25"}}, 4});
  visit(Formula{"game_normalisation", [](auto k) { return game_normalisation(k); }, Lobes{{"5"}}, 4});
  visit(Formula{"exp_by_exp2", [](auto a) { return exp_by_exp2(a); }, Lobes{{"-3"}, {"0.5"}}, 16});
  visit(Formula{"log_by_log2", [](auto a) { return log_by_log2(a); }, Lobes{{"0.25"}, {"3"}}, 8});
  visit(Formula{"misprinted_log_by_log2", [](auto a) { return misprinted_log_by_log2(a); },
                Lobes{{"0.25"}, {"3"}}, 8});
  visit(Formula{"misprinted_log_is_right_at",
                [](auto x) { return x * misprinted_log_is_right_at<decltype(x)>(); }, Lobes{{"1"}}, 16});
}

}  // namespace shadefit::testing
