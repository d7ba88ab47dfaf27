#pragma once

#include "approx/environment_map.hpp"
#include "approx/gloss.hpp"
#include "approx/harmonics.hpp"
#include "approx/kernels.hpp"
#include "approx/lobe.hpp"
#include "approx/lobe_laws.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/scalar.hpp"
#include "approx/von_mises_fisher.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of lobes and their laws.
template <class Visit>
void lobe_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes lobes{{"0.875", "5"}, {"0.75", "8"}, {"0.5", "0.5"}};
  const Lobes offset_lobes{{"0.875", "5", "0.75"}, {"0.75", "8", "0"}, {"0.5", "0.5", "1"}};
  visit(Formula{OF(power_lobe), lobes, 16});
  visit(Formula{OF(gaussian_lobe), offset_lobes, 16});
  visit(Formula{OF(power_lobe_near_peak), Lobes{{"0.125", "5"}, {"0.25", "8"}, {"0.5", "0.5"}}, 16});
  visit(Formula{OF(gaussian_lobe_near_peak), Lobes{{"0.125", "5", "0.75"}, {"0.25", "8", "0"}}, 16});
  visit(Formula{OF(lobe_log_ratio),
                Lobes{{"0.875", "0.125", "5"}, {"0.25", "0.75", "8"}, {"0.5", "0.5", "0.5"}}, 16});
  visit(Formula{OF(lobe_error), Lobes{{"0.5", "-0.125", "-0.0625"}, {"0.25", "-0.5", "-0.25"}}, 32});
  visit(Formula{OF(scaled_gaussian_lobe), Lobes{{"0.875", "5", "1.125", "0.75"}, {"0.75", "8", "0.875", "0"}},
                16});
  visit(Formula{OF(scaled_lobe_error),
                Lobes{{"0.5", "1.125", "-0.125", "-0.0625"}, {"0.25", "0.875", "-0.5", "-0.25"}}, 64});
  visit(Formula{CONSTANT(gaussian_error_ratio), 4});
  visit(Formula{PART_OF(factor_law, slope), Lobes{{"1"}, {"0.5"}}, 4});
  visit(Formula{PART_OF(offset_law, limit), Lobes{{"1", "0"}, {"0.5", "0.25"}}, 4});
  visit(Formula{PART_OF(offset_law, slope), Lobes{{"1", "0"}, {"0.5", "0.25"}}, 32});
  visit(Formula{OF(widest_gap_at), Lobes{{"5", "6"}, {"8", "8.5"}}, 8});
  visit(Formula{OF(widest_gap), Lobes{{"5", "6"}, {"8", "8.5"}}, 32});
  visit(Formula{OF(largest_error_law), Lobes{{"0"}, {"0.75"}, {"1"}}, 32});
  visit(Formula{OF(peak_crossing_residual),
                Lobes{{"0.875", "0.125", "8", "0.75"}, {"0.25", "0.75", "1", "1"}}, 64});
  visit(Formula{PART_OF(peak_crossing_law, slope), Lobes{{"0.75"}, {"1"}}, 8});
  visit(Formula{CONSTANT(blunt_offset_slope_cosine), 8});
  visit(Formula{CONSTANT(blunt_offset_slope_angle), 32});
  visit(Formula{CONSTANT(blunt_offset_slope_cosine_weighted), 16});
  visit(Formula{OF(half_angle_power), Lobes{{"0.5", "8"}}, 16});
}

/// Of kernels and the von Mises-Fisher density.
template <class Visit>
void kernels_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{OF(von_mises_fisher), Lobes{{"0.5", "2"}, {"-0.5", "8"}}, 64});
  visit(Formula{OF(von_mises_fisher_near_peak), Lobes{{"0.5", "2"}, {"0.25", "8"}}, 16});
  visit(Formula{OF(von_mises_fisher_sharp), Lobes{{"0.5", "2"}, {"0.25", "8"}}, 16});
  visit(Formula{OF(von_mises_fisher_sharp_error), Lobes{{"0.5"}, {"2"}}, 16});
  visit(Formula{OF(line_gaussian), Lobes{{"0.5", "0.25"}, {"1", "0.125"}}, 16});
  visit(Formula{OF(poisson_of_circle), Lobes{{"0.5", "0.25"}, {"0.75", "0.5"}}, 16});
  visit(Formula{OF(poisson_of_sphere), Lobes{{"0.5", "0.25"}, {"0.75", "0.5"}}, 16});
  visit(Formula{OF(poisson_sharpness), Lobes{{"0.25"}, {"0.5"}}, 8});
  visit(Formula{OF(poisson_of_circle_lobe), Lobes{{"0.25", "4"}, {"1", "8"}}, 8});
  visit(Formula{OF(poisson_of_sphere_lobe), Lobes{{"0.25", "4"}, {"1", "8"}}, 16});
  visit(Formula{"next_legendre", [](auto c, auto p, auto q) { return next_legendre(c, p, q, 2); },
                Lobes{{"0.5", "-0.125", "0.5"}}, 16});
  visit(Formula{"heat_weight", [](auto t) { return heat_weight(2, t); }, Lobes{{"0.25"}, {"0.5"}}, 32});
  visit(
      Formula{"heat_tail_bound", [](auto t) { return heat_tail_bound(2, t); }, Lobes{{"0.25"}, {"0.5"}}, 32});
  visit(Formula{"legendre_series",
                [](auto c, auto a, auto b) {
                  const std::array weights{a, b, a};
                  return legendre_series(c, std::span<const decltype(c)>(weights));
                },
                Lobes{{"0.5", "1", "0.5"}}, 16});
}

/// Of Phong's lobe and Blinn's.
template <class Visit>
void phong_blinn_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes cosines{{"0.25"}, {"0.5"}, {"0.9375"}};
  visit(Formula{OF(blinn_lobe), Lobes{{"0.125", "5", "4"}, {"0.5", "2", "4.5"}}, 16});
  visit(Formula{OF(blinn_lobe_of_cosine), Lobes{{"0.875", "5", "4"}, {"0.5", "2", "4.5"}}, 16});
  visit(Formula{OF(log_half_cosine), Lobes{{"0.5", "-0.03125"}}, 8});
  visit(Formula{OF(phong_blinn_log_ratio), Lobes{{"-0.5", "-0.03125", "5"}}, 16});
  visit(Formula{OF(phong_cosine), Lobes{{"0.5", "0.75", "0.25"}}, 4});
  visit(Formula{OF(twice_blinn_cosine), Lobes{{"0.5", "0.75", "0.25"}}, 16});
  visit(Formula{OF(blinn_cosine_excess), Lobes{{"0.5", "0.75", "0.25"}}, 16});
  visit(Formula{OF(squared_volume), Lobes{{"0.5", "0.75", "0.25"}}, 16});
  visit(Formula{OF(sine_of_half_excess), cosines, 2});
  visit(Formula{OF(angle_ratio_across), cosines, 2});
}

/// Of gloss.
template <class Visit>
void gloss_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{OF(decode_gloss), Lobes{{"0.25", "10", "1"}, {"0.875", "10", "1.5"}}, 16});
  visit(Formula{OF(base_two_power), Lobes{{"5"}}, 4});
  visit(Formula{OF(base_two_first), Lobes{{"1"}}, 4});
  visit(Formula{OF(gaussian_lobe_base_two), Lobes{{"0.75", "7"}}, 16});
  visit(Formula{"base_two_normalisation",
                [](auto m, auto b) {
                  return base_two_normalisation(m, base_two_normalisation_factor<decltype(m)>(), b);
                },
                Lobes{{"7", "0.25"}}, 4});
  visit(Formula{OF(game_normalisation), Lobes{{"5"}}, 4});
  visit(Formula{OF(exp_by_exp2), Lobes{{"-3"}, {"0.5"}}, 16});
  visit(Formula{OF(log_by_log2), Lobes{{"0.25"}, {"3"}}, 8});
  visit(Formula{OF(misprinted_log_by_log2), Lobes{{"0.25"}, {"3"}}, 8});
  visit(Formula{CONSTANT(misprinted_log_is_right_at), 16});
}

/// Of environment maps and harmonics.
template <class Visit>
void environment_map_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{OF(cap_solid_angle), Lobes{{"1"}, {"3"}}, 16});
  visit(Formula{OF(cap_solid_angle_near_axis), Lobes{{"0.5"}, {"3"}}, 16});
  visit(Formula{OF(lobe_solid_angle), Lobes{{"0.5"}, {"64"}}, 4});
  visit(Formula{OF(power_of_solid_angle), Lobes{{"0.0625"}, {"2"}}, 16});
  visit(Formula{OF(power_that_falls), Lobes{{"2", "0.015625"}, {"1", "2"}}, 8});
  visit(Formula{OF(texels_along_edge), Lobes{{"128", "2.5"}}, 4});
  visit(Formula{OF(mean_texel_solid_angle), Lobes{{"128", "2"}, {"16", "0.5"}}, 16});
  visit(Formula{OF(cube_face_density), Lobes{{"0", "0"}, {"-0.5", "1"}}, 8});
  visit(Formula{OF(cube_face_solid_angle), Lobes{{"1", "1"}, {"-0.5", "0.25"}}, 8});
  visit(Formula{OF(texel_solid_angle), Lobes{{"-1", "-1", "2"}, {"0", "0.5", "0.5"}}, 32});
  visit(Formula{OF(mip_level_of_power), Lobes{{"128", "2"}, {"16", "31"}}, 16});
  visit(Formula{OF(relative_gloss_step), Lobes{{"10", "255"}}, 8});
  visit(Formula{OF(gloss_of_level), Lobes{{"0", "6"}, {"2.5", "6"}}, 8});
  visit(Formula{OF(level_of_gloss), Lobes{{"0.25", "6", "5"}, {"0", "6", "5"}}, 4});
  visit(Formula{"power_after_drops", [](auto s, auto d) { return power_after_drops(s, d, 3); },
                Lobes{{"2048", "0.3125"}}, 8});
  visit(Formula{CONSTANT(harmonic_of_band_zero), 4});
  visit(Formula{CONSTANT(harmonic_of_band_one), 4});
  visit(Formula{"legendre_polynomial", [](auto x) { return legendre_polynomial(4, x); },
                Lobes{{"0.25"}, {"1"}}, 32});
  visit(Formula{"clamped_cosine_moment",
                [](auto one) { return one * clamped_cosine_moment<decltype(one)>(6); }, Lobes{{"1"}}, 8});
  visit(Formula{"peak_of_band", [](auto moment) { return peak_of_band(2, moment); }, Lobes{{"0.125"}}, 4});
  visit(
      Formula{"energy_of_band", [](auto moment) { return energy_of_band(2, moment); }, Lobes{{"0.125"}}, 4});
}

/// Of the functions that no formula of approx/ calls: users' formulas call them.
template <class Visit>
void vocabulary_formulas(const Visit& visit) {
  using Places = Arguments;
  visit(Formula{OF(tan), Places{{"0.25"}, {"-1.25"}}, 4});
  visit(Formula{OF(asin), Places{{"0.25"}, {"-0.9375"}}, 4});
  visit(Formula{OF(acos), Places{{"0.25"}, {"-0.5"}, {"0.9921875"}}, 4});
  visit(Formula{OF(atan2), Places{{"0.25", "0.5"}, {"0.25", "-0.5"}, {"-2", "-0.5"}, {"-2", "0.5"}}, 4});
  visit(Formula{OF(sinh), Places{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{OF(cosh), Places{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{OF(tanh), Places{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{OF(erf), Places{{"0.0625"}, {"-1"}}, 4});
  visit(Formula{OF(floor), Places{{"0.75"}, {"-2.5"}, {"3"}}, 0.5});
  visit(Formula{OF(abs), Places{{"0.75"}, {"-2.5"}}, 0.5});
  visit(Formula{"sign", [](auto x) { return signum(x); }, Places{{"0.75"}, {"-2.5"}, {"0"}}, 0.5});
}

}  // namespace shadefit::testing
