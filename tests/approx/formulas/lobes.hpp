#pragma once

#include "approx/gloss.hpp"
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
  const Rows lobes{{"0.875", "5"}, {"0.75", "8"}, {"0.5", "0.5"}};
  const Rows offset_lobes{{"0.875", "5", "0.75"}, {"0.75", "8", "0"}, {"0.5", "0.5", "1"}};
  visit(Formula{OF(power_lobe), lobes, 16});
  visit(Formula{OF(gaussian_lobe), offset_lobes, 16});
  visit(Formula{OF(power_lobe_near_peak), Rows{{"0.125", "5"}, {"0.25", "8"}, {"0.5", "0.5"}}, 16});
  visit(Formula{OF(gaussian_lobe_near_peak), Rows{{"0.125", "5", "0.75"}, {"0.25", "8", "0"}}, 16});
  visit(Formula{OF(lobe_log_ratio),
                Rows{{"0.875", "0.125", "5"}, {"0.25", "0.75", "8"}, {"0.5", "0.5", "0.5"}}, 16});
  visit(Formula{OF(lobe_error), Rows{{"0.5", "-0.125", "-0.0625"}, {"0.25", "-0.5", "-0.25"}}, 32});
  visit(Formula{OF(scaled_gaussian_lobe), Rows{{"0.875", "5", "1.125", "0.75"}, {"0.75", "8", "0.875", "0"}},
                16});
  visit(Formula{OF(scaled_lobe_error),
                Rows{{"0.5", "1.125", "-0.125", "-0.0625"}, {"0.25", "0.875", "-0.5", "-0.25"}}, 64});
  visit(Formula{CONSTANT(gaussian_error_ratio), 4});
  visit(Formula{PART_OF(factor_law, slope), Rows{{"1"}, {"0.5"}}, 4});
  visit(Formula{PART_OF(offset_law, limit), Rows{{"1", "0"}, {"0.5", "0.25"}}, 4});
  visit(Formula{PART_OF(offset_law, slope), Rows{{"1", "0"}, {"0.5", "0.25"}}, 32});
  visit(Formula{OF(widest_gap_at), Rows{{"5", "6"}, {"8", "8.5"}}, 8});
  visit(Formula{OF(widest_gap), Rows{{"5", "6"}, {"8", "8.5"}}, 32});
  visit(Formula{OF(largest_error_law), Rows{{"0"}, {"0.75"}, {"1"}}, 32});
  visit(Formula{OF(peak_crossing_residual), Rows{{"0.875", "0.125", "8", "0.75"}, {"0.25", "0.75", "1", "1"}},
                64});
  visit(Formula{PART_OF(peak_crossing_law, slope), Rows{{"0.75"}, {"1"}}, 8});
  visit(Formula{CONSTANT(blunt_offset_slope_cosine), 8});
  visit(Formula{CONSTANT(blunt_offset_slope_angle), 32});
  visit(Formula{CONSTANT(blunt_offset_slope_cosine_weighted), 16});
  visit(Formula{OF(half_angle_power), Rows{{"0.5", "8"}}, 16});
}

/// Of kernels and the von Mises-Fisher density.
template <class Visit>
void kernels_formulas(const Visit& visit) {
  visit(Formula{OF(von_mises_fisher), Rows{{"0.5", "2"}, {"-0.5", "8"}}, 64});
  visit(Formula{OF(line_gaussian), Rows{{"0.5", "0.25"}, {"1", "0.125"}}, 16});
  visit(Formula{OF(poisson_of_circle_lobe), Rows{{"0.25", "4"}, {"1", "8"}}, 8});
  visit(Formula{OF(poisson_of_sphere_lobe), Rows{{"0.25", "4"}, {"1", "8"}}, 16});
  visit(Formula{"next_legendre", [](auto c, auto p, auto q) { return next_legendre(c, p, q, 2); },
                Rows{{"0.5", "-0.125", "0.5"}}, 16});
  visit(Formula{"heat_weight", [](auto t) { return heat_weight(2, t); }, Rows{{"0.25"}, {"0.5"}}, 32});
  visit(Formula{"legendre_series",
                [](auto c, auto a, auto b) {
                  const std::array weights{a, b, a};
                  return legendre_series(c, std::span<const decltype(c)>(weights));
                },
                Rows{{"0.5", "1", "0.5"}}, 16});
}

/// Of Phong's lobe and Blinn's.
template <class Visit>
void phong_blinn_formulas(const Visit& visit) {
  visit(Formula{OF(blinn_lobe), Rows{{"0.125", "5", "4"}, {"0.5", "2", "4.5"}}, 16});
  visit(Formula{OF(blinn_lobe_of_cosine), Rows{{"0.875", "5", "4"}, {"0.5", "2", "4.5"}}, 16});
  visit(Formula{OF(log_half_cosine), Rows{{"0.5", "-0.03125"}}, 8});
  visit(Formula{OF(phong_blinn_log_ratio), Rows{{"-0.5", "-0.03125", "5"}}, 16});
}

/// Of gloss.
template <class Visit>
void gloss_formulas(const Visit& visit) {
  visit(Formula{OF(decode_gloss), Rows{{"0.25", "10", "1"}, {"0.875", "10", "1.5"}}, 16});
  visit(Formula{OF(base_two_power), Rows{{"5"}}, 4});
  visit(Formula{OF(base_two_first), Rows{{"1"}}, 4});
  visit(Formula{OF(gaussian_lobe_base_two), Rows{{"0.75", "7"}}, 16});
  visit(Formula{OF(game_normalisation), Rows{{"5"}}, 4});
}

/// Of the functions that no formula of approx/ calls: users' formulas call them.
template <class Visit>
void vocabulary_formulas(const Visit& visit) {
  visit(Formula{OF(tan), Rows{{"0.25"}, {"-1.25"}}, 4});
  visit(Formula{OF(atan), Rows{{"0.25"}, {"-1.25"}}, 4});
  visit(Formula{OF(cos), Rows{{"0.25"}, {"-1.25"}}, 4});
  visit(Formula{OF(asin), Rows{{"0.25"}, {"-0.9375"}}, 4});
  visit(Formula{OF(acos), Rows{{"0.25"}, {"-0.5"}, {"0.9921875"}}, 4});
  visit(Formula{OF(atan2), Rows{{"0.25", "0.5"}, {"0.25", "-0.5"}, {"-2", "-0.5"}, {"-2", "0.5"}}, 4});
  visit(Formula{OF(sinh), Rows{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{OF(cosh), Rows{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{OF(tanh), Rows{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{OF(erf), Rows{{"0.0625"}, {"-1"}}, 4});
  visit(Formula{OF(floor), Rows{{"0.75"}, {"-2.5"}, {"3"}}, 0.5});
  visit(Formula{OF(abs), Rows{{"0.75"}, {"-2.5"}}, 0.5});
  visit(Formula{"sign", [](auto x) { return signum(x); }, Rows{{"0.75"}, {"-2.5"}, {"0"}}, 0.5});
}

}  // namespace shadefit::testing
