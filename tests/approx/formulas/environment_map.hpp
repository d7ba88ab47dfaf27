#pragma once

#include "approx/environment_map.hpp"
#include "approx/harmonics.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of environment maps and harmonics.
template <class Visit>
void environment_map_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{"cap_solid_angle", [](auto phi) { return cap_solid_angle(phi); }, Lobes{{"1"}, {"3"}}, 16});
  visit(Formula{"cap_solid_angle_near_axis", [](auto phi) { return cap_solid_angle_near_axis(phi); },
                Lobes{{"0.5"}, {"3"}}, 16});
  visit(Formula{"lobe_solid_angle", [](auto s) { return lobe_solid_angle(s); }, Lobes{{"0.5"}, {"64"}}, 4});
  visit(Formula{"power_of_solid_angle", [](auto o) { return power_of_solid_angle(o); },
                Lobes{{"0.0625"}, {"2"}}, 16});
  visit(Formula{"power_that_falls", [](auto n, auto t) { return power_that_falls(n, t); },
                Lobes{{"2", "0.015625"}, {"1", "2"}}, 8});
  visit(Formula{"texels_along_edge", [](auto w, auto m) { return texels_along_edge(w, m); },
                Lobes{{"128", "2.5"}}, 4});
  visit(Formula{"mean_texel_solid_angle", [](auto w, auto m) { return mean_texel_solid_angle(w, m); },
                Lobes{{"128", "2"}, {"16", "0.5"}}, 16});
  visit(Formula{"cube_face_density", [](auto x, auto y) { return cube_face_density(x, y); },
                Lobes{{"0", "0"}, {"-0.5", "1"}}, 8});
  visit(Formula{"cube_face_solid_angle", [](auto x, auto y) { return cube_face_solid_angle(x, y); },
                Lobes{{"1", "1"}, {"-0.5", "0.25"}}, 8});
  visit(Formula{"texel_solid_angle", [](auto x, auto y, auto size) { return texel_solid_angle(x, y, size); },
                Lobes{{"-1", "-1", "2"}, {"0", "0.5", "0.5"}}, 32});
  visit(Formula{"mip_level_of_power", [](auto w, auto s) { return mip_level_of_power(w, s); },
                Lobes{{"128", "2"}, {"16", "31"}}, 16});
  visit(Formula{"relative_gloss_step", [](auto o, auto n) { return relative_gloss_step(o, n); },
                Lobes{{"10", "255"}}, 8});
  visit(Formula{"gloss_of_level", [](auto m, auto n) { return gloss_of_level(m, n); },
                Lobes{{"0", "6"}, {"2.5", "6"}}, 8});
  visit(Formula{"level_of_gloss", [](auto g, auto n, auto last) { return level_of_gloss(g, n, last); },
                Lobes{{"0.25", "6", "5"}, {"0", "6", "5"}}, 4});
  visit(Formula{"power_after_drops", [](auto s, auto d) { return power_after_drops(s, d, 3); },
                Lobes{{"2048", "0.3125"}}, 8});
  visit(Formula{"harmonic_of_band_zero",
                [](auto one) { return one * harmonic_of_band_zero<decltype(one)>(); }, Lobes{{"1"}}, 4});
  visit(Formula{"harmonic_of_band_one", [](auto one) { return one * harmonic_of_band_one<decltype(one)>(); },
                Lobes{{"1"}}, 4});
  visit(Formula{"legendre_polynomial", [](auto x) { return legendre_polynomial(4, x); },
                Lobes{{"0.25"}, {"1"}}, 32});
  visit(Formula{"clamped_cosine_moment",
                [](auto one) { return one * clamped_cosine_moment<decltype(one)>(6); }, Lobes{{"1"}}, 8});
  visit(Formula{"peak_of_band", [](auto moment) { return peak_of_band(2, moment); }, Lobes{{"0.125"}}, 4});
  visit(
      Formula{"energy_of_band", [](auto moment) { return energy_of_band(2, moment); }, Lobes{{"0.125"}}, 4});
}

}  // namespace shadefit::testing
