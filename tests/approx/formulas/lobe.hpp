#pragma once

#include "approx/lobe.hpp"
#include "approx/lobe_laws.hpp"
#include "approx/phong_blinn.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of lobes and their laws.
template <class Visit>
void lobe_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes lobes{{"0.875", "5"}, {"0.75", "8"}, {"0.5", "0.5"}};
  const Lobes offset_lobes{{"0.875", "5", "0.75"}, {"0.75", "8", "0"}, {"0.5", "0.5", "1"}};
  visit(Formula{"power_lobe", [](auto c, auto k) { return power_lobe(c, k); }, lobes, 16});
  visit(Formula{"gaussian_lobe", [](auto c, auto k, auto x) { return gaussian_lobe(c, k, x); }, offset_lobes,
                16});
  visit(Formula{"power_lobe_near_peak", [](auto y, auto k) { return power_lobe_near_peak(y, k); },
                Lobes{{"0.125", "5"}, {"0.25", "8"}, {"0.5", "0.5"}}, 16});
  visit(Formula{"gaussian_lobe_near_peak",
                [](auto y, auto k, auto x) { return gaussian_lobe_near_peak(y, k, x); },
                Lobes{{"0.125", "5", "0.75"}, {"0.25", "8", "0"}}, 16});
  visit(Formula{"lobe_log_ratio", [](auto c, auto y, auto k) { return lobe_log_ratio(c, y, k); },
                Lobes{{"0.875", "0.125", "5"}, {"0.25", "0.75", "8"}, {"0.5", "0.5", "0.5"}}, 16});
  visit(Formula{"lobe_error", [](auto b, auto c, auto r) { return lobe_error(b, c, r); },
                Lobes{{"0.5", "-0.125", "-0.0625"}, {"0.25", "-0.5", "-0.25"}}, 32});
  visit(Formula{"lobe_relative_error", [](auto c, auto l) { return lobe_relative_error(c, l); },
                Lobes{{"-0.125", "-0.0625"}, {"-0.5", "-1"}}, 32});
  visit(Formula{"scaled_gaussian_lobe",
                [](auto c, auto k, auto a, auto x) { return scaled_gaussian_lobe(c, k, a, x); },
                Lobes{{"0.875", "5", "1.125", "0.75"}, {"0.75", "8", "0.875", "0"}}, 16});
  visit(Formula{"scaled_lobe_error",
                [](auto b, auto a, auto c, auto r) { return scaled_lobe_error(b, a, c, r); },
                Lobes{{"0.5", "1.125", "-0.125", "-0.0625"}, {"0.25", "0.875", "-0.5", "-0.25"}}, 64});
  visit(Formula{"scaled_lobe_relative_error",
                [](auto a, auto c, auto l) { return scaled_lobe_relative_error(a, c, l); },
                Lobes{{"1.125", "-0.125", "-0.0625"}, {"0.875", "-0.5", "-1"}}, 64});
  visit(Formula{"gaussian_error_ratio", [](auto x) { return x * gaussian_error_ratio<decltype(x)>(); },
                Lobes{{"1"}}, 4});
  visit(Formula{"factor_law.slope", [](auto p) { return factor_law(p).slope; }, Lobes{{"1"}, {"0.5"}}, 4});
  visit(Formula{"offset_law.limit", [](auto p, auto w) { return offset_law(p, w).limit; },
                Lobes{{"1", "0"}, {"0.5", "0.25"}}, 4});
  visit(Formula{"offset_law.slope", [](auto p, auto w) { return offset_law(p, w).slope; },
                Lobes{{"1", "0"}, {"0.5", "0.25"}}, 32});
  visit(Formula{"widest_gap_at", [](auto a, auto b) { return widest_gap_at(a, b); },
                Lobes{{"5", "6"}, {"8", "8.5"}}, 8});
  visit(Formula{"widest_gap", [](auto a, auto b) { return widest_gap(a, b); },
                Lobes{{"5", "6"}, {"8", "8.5"}}, 32});
  visit(Formula{"largest_error_law", [](auto x) { return largest_error_law(x); },
                Lobes{{"0"}, {"0.75"}, {"1"}}, 32});
  visit(Formula{"peak_crossing_residual",
                [](auto c, auto y, auto k, auto x) { return peak_crossing_residual(c, y, k, x); },
                Lobes{{"0.875", "0.125", "8", "0.75"}, {"0.25", "0.75", "1", "1"}}, 64});
  visit(Formula{"peak_crossing_law.slope", [](auto x) { return peak_crossing_law(x).slope; },
                Lobes{{"0.75"}, {"1"}}, 8});
  visit(Formula{"blunt_offset_slope_cosine",
                [](auto x) { return x * blunt_offset_slope_cosine<decltype(x)>(); }, Lobes{{"1"}}, 8});
  visit(Formula{"blunt_offset_slope_angle",
                [](auto x) { return x * blunt_offset_slope_angle<decltype(x)>(); }, Lobes{{"1"}}, 32});
  visit(Formula{"blunt_offset_slope_cosine_weighted",
                [](auto x) { return x * blunt_offset_slope_cosine_weighted<decltype(x)>(); }, Lobes{{"1"}},
                16});
  visit(Formula{"half_angle_power", [](auto y, auto a) { return half_angle_power(y, a); },
                Lobes{{"0.5", "8"}}, 16});
}

}  // namespace shadefit::testing
