#pragma once

#include "approx/phong_blinn.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of Phong's lobe and Blinn's.
template <class Visit>
void phong_blinn_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes cosines{{"0.25"}, {"0.5"}, {"0.9375"}};
  visit(Formula{"blinn_lobe", [](auto y, auto k, auto x) { return blinn_lobe(y, k, x); },
                Lobes{{"0.125", "5", "4"}, {"0.5", "2", "4.5"}}, 16});
  visit(Formula{"blinn_lobe_of_cosine", [](auto c, auto k, auto x) { return blinn_lobe_of_cosine(c, k, x); },
                Lobes{{"0.875", "5", "4"}, {"0.5", "2", "4.5"}}, 16});
  visit(Formula{"log_half_cosine", [](auto y, auto r) { return log_half_cosine(y, r); },
                Lobes{{"0.5", "-0.03125"}}, 8});
  visit(Formula{"phong_blinn_log_ratio",
                [](auto l, auto r, auto k) { return phong_blinn_log_ratio(l, r, k); },
                Lobes{{"-0.5", "-0.03125", "5"}}, 16});
  visit(Formula{"phong_cosine", [](auto l, auto v, auto d) { return phong_cosine(l, v, d); },
                Lobes{{"0.5", "0.75", "0.25"}}, 4});
  visit(Formula{"twice_blinn_cosine", [](auto l, auto v, auto d) { return twice_blinn_cosine(l, v, d); },
                Lobes{{"0.5", "0.75", "0.25"}}, 16});
  visit(Formula{"blinn_cosine_excess", [](auto l, auto v, auto d) { return blinn_cosine_excess(l, v, d); },
                Lobes{{"0.5", "0.75", "0.25"}}, 16});
  visit(Formula{"squared_volume", [](auto l, auto v, auto d) { return squared_volume(l, v, d); },
                Lobes{{"0.5", "0.75", "0.25"}}, 16});
  visit(Formula{"sine_of_half_excess", [](auto v) { return sine_of_half_excess(v); }, cosines, 2});
  visit(Formula{"angle_ratio_across", [](auto v) { return angle_ratio_across(v); }, cosines, 2});
}

}  // namespace shadefit::testing
