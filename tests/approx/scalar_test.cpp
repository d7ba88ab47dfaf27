#include "approx/scalar.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "approx/arithmetic.hpp"
#include "approx/cost.hpp"
#include "approx/dither.hpp"
#include "approx/encoding.hpp"
#include "approx/environment_map.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/harmonics.hpp"
#include "approx/kernels.hpp"
#include "approx/lobe.hpp"
#include "approx/lobe_laws.hpp"
#include "approx/material.hpp"
#include "approx/microfacet.hpp"
#include "approx/normalisation.hpp"
#include "approx/phase.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/reflectance.hpp"
#include "approx/von_mises_fisher.hpp"
#include "fit/half.hpp"
#include "fit/half_result.hpp"
#include "fit/interval.hpp"
#include "fit/jet.hpp"
#include "fit/multiprecision.hpp"
#include "fit/symbolic.hpp"
#include "tests/accuracy.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

using testing::contains;
using testing::end;
using testing::is_close;

/// A formula as a callable on any scalar, with arguments that every scalar (half included) holds exactly, and
/// the relative error in units of the scalar's epsilon that rounding may cause: an exponential multiplies the
/// rounding of its argument by that argument, a difference by the ratio of its terms to it.
template <class F>
struct Formula {
  const char* name;
  F call;
  std::vector<std::vector<const char*>> arguments;
  double epsilons;
};

template <class F>
Formula(const char*, F, std::vector<std::vector<const char*>>, double) -> Formula<F>;

template <class T>
Arc<T> arc_to(const T& angle) {
  return {angle, sin(angle), cos(angle)};
}

template <class T>
Direction<T> direction_of(const T& angle) {
  return {cos(angle), sin(angle)};
}

template <class T>
MicrofacetNormal<T> normal_of(const T& cos2) {
  return {cos2, integer<T>(1) - cos2};
}

auto formulas() {
  using Lobes = std::vector<std::vector<const char*>>;
  const Lobes cosines{{"0.25"}, {"0.5"}, {"0.9375"}};
  const Lobes lobes{{"0.875", "5"}, {"0.75", "8"}, {"0.5", "0.5"}};
  const Lobes offset_lobes{{"0.875", "5", "0.75"}, {"0.75", "8", "0"}, {"0.5", "0.5", "1"}};
  const Lobes arcs{{"0.5", "0.75", "1"}, {"0.5", "-0.25", "3"}};
  // y, a, the view angle and the end of the arc; and g, a, the view's elevation and the latitudes' integral
  const Lobes circles{{"0.25", "5", "0.5", "2"}, {"0.5", "8", "1", "1.5"}};
  const Lobes longitudes{{"0.5", "5", "0.25"}, {"1", "8", "1"}};
  const Lobes meridians{{"0.5", "5", "0.25", "0.5"}, {"1", "8", "1", "0.25"}};
  const Lobes factors{{"0.25", "0.5", "0.03125"}};
  const Lobes scatterings{{"0.5", "0.25"}, {"0.25", "-0.5"}, {"1", "0"}};
  // cos^2 of the angle between m and n, and alpha; 1 is the limit of GTR1
  const Lobes microfacets{{"0.75", "0.5"}, {"0.25", "0.75"}, {"0.5", "1"}};
  return std::tuple{
      Formula{"power_lobe", [](auto c, auto k) { return power_lobe(c, k); }, lobes, 16},
      Formula{"gaussian_lobe", [](auto c, auto k, auto x) { return gaussian_lobe(c, k, x); }, offset_lobes,
              16},
      Formula{"power_lobe_near_peak", [](auto y, auto k) { return power_lobe_near_peak(y, k); },
              Lobes{{"0.125", "5"}, {"0.25", "8"}, {"0.5", "0.5"}}, 16},
      Formula{"gaussian_lobe_near_peak",
              [](auto y, auto k, auto x) { return gaussian_lobe_near_peak(y, k, x); },
              Lobes{{"0.125", "5", "0.75"}, {"0.25", "8", "0"}}, 16},
      Formula{"lobe_log_ratio", [](auto c, auto y, auto k) { return lobe_log_ratio(c, y, k); },
              Lobes{{"0.875", "0.125", "5"}, {"0.25", "0.75", "8"}, {"0.5", "0.5", "0.5"}}, 16},
      Formula{"lobe_error", [](auto b, auto c, auto r) { return lobe_error(b, c, r); },
              Lobes{{"0.5", "-0.125", "-0.0625"}, {"0.25", "-0.5", "-0.25"}}, 32},
      Formula{"lobe_relative_error", [](auto c, auto l) { return lobe_relative_error(c, l); },
              Lobes{{"-0.125", "-0.0625"}, {"-0.5", "-1"}}, 32},
      Formula{"blinn_lobe", [](auto y, auto k, auto x) { return blinn_lobe(y, k, x); },
              Lobes{{"0.125", "5", "4"}, {"0.5", "2", "4.5"}}, 16},
      Formula{"blinn_lobe_of_cosine", [](auto c, auto k, auto x) { return blinn_lobe_of_cosine(c, k, x); },
              Lobes{{"0.875", "5", "4"}, {"0.5", "2", "4.5"}}, 16},
      Formula{"log_half_cosine", [](auto y, auto r) { return log_half_cosine(y, r); },
              Lobes{{"0.5", "-0.03125"}}, 8},
      Formula{"phong_blinn_log_ratio", [](auto l, auto r, auto k) { return phong_blinn_log_ratio(l, r, k); },
              Lobes{{"-0.5", "-0.03125", "5"}}, 16},
      Formula{"phong_cosine", [](auto l, auto v, auto d) { return phong_cosine(l, v, d); },
              Lobes{{"0.5", "0.75", "0.25"}}, 4},
      Formula{"twice_blinn_cosine", [](auto l, auto v, auto d) { return twice_blinn_cosine(l, v, d); },
              Lobes{{"0.5", "0.75", "0.25"}}, 16},
      Formula{"blinn_cosine_excess", [](auto l, auto v, auto d) { return blinn_cosine_excess(l, v, d); },
              Lobes{{"0.5", "0.75", "0.25"}}, 16},
      Formula{"squared_volume", [](auto l, auto v, auto d) { return squared_volume(l, v, d); },
              Lobes{{"0.5", "0.75", "0.25"}}, 16},
      Formula{"sine_of_half_excess", [](auto v) { return sine_of_half_excess(v); }, cosines, 2},
      Formula{"angle_ratio_across", [](auto v) { return angle_ratio_across(v); }, cosines, 2},
      Formula{"von_mises_fisher", [](auto c, auto k) { return von_mises_fisher(c, k); },
              Lobes{{"0.5", "2"}, {"-0.5", "8"}}, 64},
      Formula{"von_mises_fisher_near_peak", [](auto y, auto k) { return von_mises_fisher_near_peak(y, k); },
              Lobes{{"0.5", "2"}, {"0.25", "8"}}, 16},
      Formula{"von_mises_fisher_sharp", [](auto y, auto k) { return von_mises_fisher_sharp(y, k); },
              Lobes{{"0.5", "2"}, {"0.25", "8"}}, 16},
      Formula{"von_mises_fisher_sharp_error", [](auto k) { return von_mises_fisher_sharp_error(k); },
              Lobes{{"0.5"}, {"2"}}, 16},
      Formula{"line_gaussian", [](auto x, auto t) { return line_gaussian(x, t); },
              Lobes{{"0.5", "0.25"}, {"1", "0.125"}}, 16},
      Formula{"poisson_of_circle", [](auto c, auto t) { return poisson_of_circle(c, t); },
              Lobes{{"0.5", "0.25"}, {"0.75", "0.5"}}, 16},
      Formula{"poisson_of_sphere", [](auto c, auto t) { return poisson_of_sphere(c, t); },
              Lobes{{"0.5", "0.25"}, {"0.75", "0.5"}}, 16},
      Formula{"poisson_sharpness", [](auto t) { return poisson_sharpness(t); }, Lobes{{"0.25"}, {"0.5"}}, 8},
      Formula{"poisson_of_circle_lobe", [](auto y, auto m) { return poisson_of_circle_lobe(y, m); },
              Lobes{{"0.25", "4"}, {"1", "8"}}, 8},
      Formula{"poisson_of_sphere_lobe", [](auto y, auto m) { return poisson_of_sphere_lobe(y, m); },
              Lobes{{"0.25", "4"}, {"1", "8"}}, 16},
      Formula{"next_legendre", [](auto c, auto p, auto q) { return next_legendre(c, p, q, 2); },
              Lobes{{"0.5", "-0.125", "0.5"}}, 16},
      Formula{"heat_weight", [](auto t) { return heat_weight(2, t); }, Lobes{{"0.25"}, {"0.5"}}, 32},
      Formula{"heat_tail_bound", [](auto t) { return heat_tail_bound(2, t); }, Lobes{{"0.25"}, {"0.5"}}, 32},
      Formula{"legendre_series",
              [](auto c, auto a, auto b) {
                const std::array weights{a, b, a};
                return legendre_series(c, std::span<const decltype(c)>(weights));
              },
              Lobes{{"0.5", "1", "0.5"}}, 16},
      Formula{"gaussian_error_ratio", [](auto x) { return x * gaussian_error_ratio<decltype(x)>(); },
              Lobes{{"1"}}, 4},
      Formula{"factor_law.slope", [](auto p) { return factor_law(p).slope; }, Lobes{{"1"}, {"0.5"}}, 4},
      Formula{"offset_law.limit", [](auto p, auto w) { return offset_law(p, w).limit; },
              Lobes{{"1", "0"}, {"0.5", "0.25"}}, 4},
      Formula{"offset_law.slope", [](auto p, auto w) { return offset_law(p, w).slope; },
              Lobes{{"1", "0"}, {"0.5", "0.25"}}, 32},
      Formula{"grazing_power", [](auto c) { return grazing_power(c, 4); }, cosines, 8},
      Formula{"fresnel_quadratic_exponent",
              [](auto c, auto a, auto b) { return fresnel_quadratic_exponent(c, a, b); },
              Lobes{{"0.5", "-5.5", "-7"}}, 4},
      Formula{"schlick_reflectance_of_gloss",
              [](auto f, auto g, auto w) { return schlick_reflectance_of_gloss(f, g, w); },
              Lobes{{"0.0625", "0.5", "0.25"}, {"0.5", "0.25", "0.25"}}, 4},
      Formula{"widest_gap_at", [](auto a, auto b) { return widest_gap_at(a, b); },
              Lobes{{"5", "6"}, {"8", "8.5"}}, 8},
      Formula{"widest_gap", [](auto a, auto b) { return widest_gap(a, b); }, Lobes{{"5", "6"}, {"8", "8.5"}},
              32},
      Formula{"largest_error_law", [](auto x) { return largest_error_law(x); }, Lobes{{"0"}, {"0.75"}, {"1"}},
              32},
      Formula{"peak_crossing_residual",
              [](auto c, auto y, auto k, auto x) { return peak_crossing_residual(c, y, k, x); },
              Lobes{{"0.875", "0.125", "8", "0.75"}, {"0.25", "0.75", "1", "1"}}, 64},
      Formula{"peak_crossing_law.slope", [](auto x) { return peak_crossing_law(x).slope; },
              Lobes{{"0.75"}, {"1"}}, 8},
      Formula{"blunt_offset_slope_cosine",
              [](auto x) { return x * blunt_offset_slope_cosine<decltype(x)>(); }, Lobes{{"1"}}, 8},
      Formula{"blunt_offset_slope_angle", [](auto x) { return x * blunt_offset_slope_angle<decltype(x)>(); },
              Lobes{{"1"}}, 32},
      Formula{"blunt_offset_slope_cosine_weighted",
              [](auto x) { return x * blunt_offset_slope_cosine_weighted<decltype(x)>(); }, Lobes{{"1"}}, 16},
      Formula{"decode_gloss", [](auto g, auto d, auto f) { return decode_gloss(g, d, f); },
              Lobes{{"0.25", "10", "1"}, {"0.875", "10", "1.5"}}, 16},
      Formula{"base_two_power", [](auto k) { return base_two_power(k); }, Lobes{{"5"}}, 4},
      Formula{"base_two_first", [](auto f) { return base_two_first(f); }, Lobes{{"1"}}, 4},
      Formula{"gaussian_lobe_base_two", [](auto c, auto m) { return gaussian_lobe_base_two(c, m); },
              Lobes{{"0.75", "7"}}, 16},
      Formula{"base_two_normalisation",
              [](auto m, auto b) {
                return base_two_normalisation(m, base_two_normalisation_factor<decltype(m)>(), b);
              },
              Lobes{{"7", "0.25"}}, 4},
      Formula{"game_normalisation", [](auto k) { return game_normalisation(k); }, Lobes{{"5"}}, 4},
      Formula{"exp_by_exp2", [](auto a) { return exp_by_exp2(a); }, Lobes{{"-3"}, {"0.5"}}, 16},
      Formula{"log_by_log2", [](auto a) { return log_by_log2(a); }, Lobes{{"0.25"}, {"3"}}, 8},
      Formula{"misprinted_log_by_log2", [](auto a) { return misprinted_log_by_log2(a); },
              Lobes{{"0.25"}, {"3"}}, 8},
      Formula{"misprinted_log_is_right_at",
              [](auto x) { return x * misprinted_log_is_right_at<decltype(x)>(); }, Lobes{{"1"}}, 16},
      Formula{"schlick_weight", [](auto c) { return schlick_weight(c); }, cosines, 8},
      Formula{"schlick_reflectance", [](auto f, auto w) { return schlick_reflectance(f, w); },
              Lobes{{"0.0625", "0.5"}}, 4},
      Formula{"reflectance_at_normal", [](auto n) { return reflectance_at_normal(n); },
              Lobes{{"1.5"}, {"0.5"}}, 8},
      Formula{"dielectric_reflectance", [](auto c, auto n) { return dielectric_reflectance(c, n); },
              Lobes{{"0.25", "1.5"}, {"0.875", "2"}, {"0.875", "0.75"}}, 64},
      Formula{"conductor_reflectance_at_normal",
              [](auto n, auto k) { return conductor_reflectance_at_normal(n, k); },
              Lobes{{"1.5", "0"}, {"0.25", "3.5"}}, 16},
      Formula{"conductor_reflectance", [](auto c, auto n, auto k) { return conductor_reflectance(c, n, k); },
              Lobes{{"0.25", "1.5", "0.5"}, {"0.875", "0.25", "3.5"}, {"0.5", "1.5", "7.5"}}, 128},
      Formula{"weight_of_reflectance", [](auto f, auto f0) { return weight_of_reflectance(f, f0); },
              Lobes{{"0.75", "0.5"}}, 4},
      Formula{"fresnel_one_term", [](auto c, auto a) { return fresnel_one_term(c, a); },
              Lobes{{"0.25", "8"}, {"0.5", "8.5"}}, 16},
      Formula{"fresnel_quadratic", [](auto c, auto a, auto b) { return fresnel_quadratic(c, a, b); },
              Lobes{{"0.25", "-5.5", "-7"}, {"0.5", "-5.5", "-7"}}, 16},
      Formula{"one_term_sharpness", [](auto x) { return one_term_sharpness(x); }, Lobes{{"0.75"}, {"1"}}, 4},
      Formula{"half_angle_power", [](auto y, auto a) { return half_angle_power(y, a); }, Lobes{{"0.5", "8"}},
              16},
      Formula{"LambertLobe::constant", [](auto a) { return LambertLobe::constant(a); }, Lobes{{"1"}}, 4},
      Formula{"PhongLobe::constant", [](auto a) { return PhongLobe::constant(a); }, Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"PhongBrdfLobe::lobe", [](auto y, auto a) { return PhongBrdfLobe::lobe(y, a); },
              Lobes{{"0.25", "8"}}, 16},
      Formula{"PhongBrdfLobe::constant", [](auto a) { return PhongBrdfLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"BlinnPhongLobe::constant", [](auto a) { return BlinnPhongLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 8},
      Formula{"BlinnPhongBrdfLobe::lobe", [](auto y, auto a) { return BlinnPhongBrdfLobe::lobe(y, a); },
              Lobes{{"0.25", "8"}}, 16},
      Formula{"BlinnPhongBrdfLobe::constant", [](auto a) { return BlinnPhongBrdfLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 8},
      Formula{"BlinnPhongCheapLobe::constant", [](auto a) { return BlinnPhongCheapLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"MicrofacetLobe::lobe", [](auto y, auto a) { return MicrofacetLobe::lobe(y, a); },
              Lobes{{"0.25", "8"}}, 16},
      Formula{"MicrofacetLobe::constant", [](auto a) { return MicrofacetLobe::constant(a); },
              Lobes{{"0.5"}, {"8"}}, 4},
      Formula{"arc_of_line", [](auto p, auto q, auto phi) { return arc_of_line(p, q, arc_to(phi)); }, arcs,
              16},
      Formula{"arc_of_square", [](auto p, auto q, auto phi) { return arc_of_square(p, q, arc_to(phi)); },
              arcs, 16},
      Formula{"phong_circle.plain",
              [](auto y, auto a, auto view, auto phi) {
                return phong_circle(y, a, direction_of(view), arc_to(phi)).plain;
              },
              circles, 32},
      Formula{"phong_circle.with_cosine",
              [](auto y, auto a, auto view, auto phi) {
                return phong_circle(y, a, direction_of(view), arc_to(phi)).with_cosine;
              },
              circles, 32},
      Formula{"blinn_phong_circle.plain",
              [](auto y, auto a, auto view, auto phi) {
                return blinn_phong_circle(y, a, direction_of(view), arc_to(phi)).plain;
              },
              circles, 32},
      Formula{"blinn_phong_circle.with_cosine",
              [](auto y, auto a, auto view, auto phi) {
                return blinn_phong_circle(y, a, direction_of(view), arc_to(phi)).with_cosine;
              },
              circles, 64},
      Formula{"cosine_power", [](auto x, auto a) { return cosine_power(x, a); },
              Lobes{{"0.25", "5"}, {"-1", "8"}}, 32},
      Formula{"phong_longitude.plain", [](auto g, auto a, auto e) { return phong_longitude(g, a, e).plain; },
              longitudes, 32},
      Formula{"phong_longitude.with_cosine",
              [](auto g, auto a, auto e) { return phong_longitude(g, a, e).with_cosine; }, longitudes, 32},
      Formula{"phong_latitude.plain", [](auto z, auto a) { return phong_latitude(z, a).plain; },
              Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16},
      Formula{"phong_latitude.with_cosine", [](auto z, auto a) { return phong_latitude(z, a).with_cosine; },
              Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16},
      Formula{"blinn_phong_longitude", [](auto g, auto a, auto e) { return blinn_phong_longitude(g, a, e); },
              longitudes, 32},
      Formula{"horizon_latitude", [](auto g, auto e) { return horizon_latitude(g, e); },
              Lobes{{"0.5", "0.25"}, {"1", "1"}}, 16},
      Formula{"blinn_phong_latitude.one", [](auto z, auto a) { return blinn_phong_latitude(z, a).one; },
              Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16},
      Formula{"blinn_phong_latitude.z_squared",
              [](auto z, auto a) { return blinn_phong_latitude(z, a).z_squared; },
              Lobes{{"0.25", "5"}, {"-0.5", "8"}}, 16},
      Formula{"blinn_phong_meridian.plain",
              [](auto g, auto a, auto e, auto one) {
                return blinn_phong_meridian(g, a, e, {one, one * one}).plain;
              },
              meridians, 32},
      Formula{"blinn_phong_meridian.with_cosine",
              [](auto g, auto a, auto e, auto one) {
                return blinn_phong_meridian(g, a, e, {one, one * one}).with_cosine;
              },
              meridians, 64},
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
      Formula{"power_by_exp2", [](auto c, auto k) { return power_by_exp2(c, k); }, lobes, 16},
      Formula{"gaussian_lobe_base_two_of_difference",
              [](auto c, auto a) { return gaussian_lobe_base_two_of_difference(c, a); }, lobes, 16},
      Formula{"mip_level_of_successor", [](auto w, auto s) { return mip_level_of_successor(w, s); },
              Lobes{{"128", "8"}}, 16},
      Formula{
          "phong_by_exp2",
          [](auto r, auto l, auto a) {
            using T = decltype(a);
            return phong_by_exp2(scaled_reflection(std::array<T, 3>{r, r, r}, a), std::array<T, 3>{l, l, r});
          },
          Lobes{{"0.5", "0.625", "8"}}, 16},
      Formula{"phong_cosine",
              [](auto r, auto l, auto m) {
                using T = decltype(m);
                return phong_cosine(std::array<T, 3>{r, l, m}, std::array<T, 3>{l, l, m});
              },
              Lobes{{"0.5", "0.625", "0.25"}}, 8},
      Formula{"srgb_code", [](auto x) { return srgb_code(x); }, Lobes{{"0.5"}, {"1.5"}}, 16},
      Formula{"cap_solid_angle", [](auto phi) { return cap_solid_angle(phi); }, Lobes{{"1"}, {"3"}}, 16},
      Formula{"cap_solid_angle_near_axis", [](auto phi) { return cap_solid_angle_near_axis(phi); },
              Lobes{{"0.5"}, {"3"}}, 16},
      Formula{"lobe_solid_angle", [](auto s) { return lobe_solid_angle(s); }, Lobes{{"0.5"}, {"64"}}, 4},
      Formula{"power_of_solid_angle", [](auto o) { return power_of_solid_angle(o); },
              Lobes{{"0.0625"}, {"2"}}, 16},
      Formula{"power_that_falls", [](auto n, auto t) { return power_that_falls(n, t); },
              Lobes{{"2", "0.015625"}, {"1", "2"}}, 8},
      Formula{"texels_along_edge", [](auto w, auto m) { return texels_along_edge(w, m); },
              Lobes{{"128", "2.5"}}, 4},
      Formula{"mean_texel_solid_angle", [](auto w, auto m) { return mean_texel_solid_angle(w, m); },
              Lobes{{"128", "2"}, {"16", "0.5"}}, 16},
      Formula{"cube_face_density", [](auto x, auto y) { return cube_face_density(x, y); },
              Lobes{{"0", "0"}, {"-0.5", "1"}}, 8},
      Formula{"cube_face_solid_angle", [](auto x, auto y) { return cube_face_solid_angle(x, y); },
              Lobes{{"1", "1"}, {"-0.5", "0.25"}}, 8},
      Formula{"texel_solid_angle", [](auto x, auto y, auto size) { return texel_solid_angle(x, y, size); },
              Lobes{{"-1", "-1", "2"}, {"0", "0.5", "0.5"}}, 32},
      Formula{"mip_level_of_power", [](auto w, auto s) { return mip_level_of_power(w, s); },
              Lobes{{"128", "2"}, {"16", "31"}}, 16},
      Formula{"relative_gloss_step", [](auto o, auto n) { return relative_gloss_step(o, n); },
              Lobes{{"10", "255"}}, 8},
      Formula{"gloss_of_level", [](auto m, auto n) { return gloss_of_level(m, n); },
              Lobes{{"0", "6"}, {"2.5", "6"}}, 8},
      Formula{"level_of_gloss", [](auto g, auto n, auto last) { return level_of_gloss(g, n, last); },
              Lobes{{"0.25", "6", "5"}, {"0", "6", "5"}}, 4},
      Formula{"power_after_drops", [](auto s, auto d) { return power_after_drops(s, d, 3); },
              Lobes{{"2048", "0.3125"}}, 8},
      Formula{"harmonic_of_band_zero", [](auto one) { return one * harmonic_of_band_zero<decltype(one)>(); },
              Lobes{{"1"}}, 4},
      Formula{"harmonic_of_band_one", [](auto one) { return one * harmonic_of_band_one<decltype(one)>(); },
              Lobes{{"1"}}, 4},
      Formula{"legendre_polynomial", [](auto x) { return legendre_polynomial(4, x); }, Lobes{{"0.25"}, {"1"}},
              32},
      Formula{"clamped_cosine_moment", [](auto one) { return one * clamped_cosine_moment<decltype(one)>(6); },
              Lobes{{"1"}}, 8},
      Formula{"peak_of_band", [](auto moment) { return peak_of_band(2, moment); }, Lobes{{"0.125"}}, 4},
      Formula{"energy_of_band", [](auto moment) { return energy_of_band(2, moment); }, Lobes{{"0.125"}}, 4},
      Formula{"srgb_encode", [](auto x) { return srgb_encode(x); }, Lobes{{"0.001953125"}, {"0.5"}, {"1"}},
              16},
      Formula{"srgb_decode", [](auto x) { return srgb_decode(x); }, Lobes{{"0.03125"}, {"0.5"}, {"1"}}, 16},
      Formula{"gamma_encode", [](auto x, auto g) { return gamma_encode(x, g); },
              Lobes{{"0.25", "2.25"}, {"1", "2.25"}}, 8},
      Formula{"gamma_decode", [](auto x, auto g) { return gamma_decode(x, g); },
              Lobes{{"0.25", "2.25"}, {"1", "2.25"}}, 8},
      Formula{"metallic_albedo", [](auto c, auto m) { return metallic_albedo(c, m); },
              Lobes{{"0.75", "0.25"}}, 4},
      Formula{"metallic_f0", [](auto f, auto c, auto m) { return metallic_f0(f, c, m); },
              Lobes{{"0.03125", "0.75", "0.25"}}, 4},
      Formula{"brightest_base_colour", [](auto f, auto m) { return brightest_base_colour(f, m); },
              Lobes{{"0.03125", "0.25"}}, 4},
      Formula{"mean_schlick_reflectance", [](auto f) { return mean_schlick_reflectance(f); },
              Lobes{{"0.03125"}, {"0.5"}}, 4},
      Formula{"TransmittedBothWays",
              [](auto i, auto o, auto f) { return TransmittedBothWays::factor(i, o, f); }, factors, 4},
      Formula{"TransmittedIn", [](auto i, auto o, auto f) { return TransmittedIn::factor(i, o, f); }, factors,
              4},
      Formula{"TransmittedAtNormal",
              [](auto i, auto o, auto f) { return TransmittedAtNormal::factor(i, o, f); }, factors, 4},
      Formula{"Unattenuated", [](auto i, auto o, auto f) { return Unattenuated::factor(i, o, f); }, factors,
              4},
      Formula{"henyey_greenstein", [](auto c, auto g) { return henyey_greenstein(c, g); }, scatterings, 32},
      Formula{"henyey_greenstein_near_peak", [](auto y, auto g) { return henyey_greenstein_near_peak(y, g); },
              scatterings, 32},
      Formula{"henyey_greenstein_within", [](auto y, auto g) { return henyey_greenstein_within(y, g); },
              scatterings, 32},
      Formula{"march_rms", [](auto n) { return march_rms(n); }, Lobes{{"10"}, {"100"}}, 4},
      Formula{"march_rms_at_offset", [](auto n, auto d) { return march_rms_at_offset(n, d); },
              Lobes{{"10", "0.25"}, {"100", "0"}}, 8},
      Formula{"depth_weight", [](auto gap, auto falloff) { return depth_weight(gap, falloff); },
              Lobes{{"2", "0.0625"}}, 4},
      Formula{"guarded_mean", [](auto sum, auto w, auto epsilon) { return guarded_mean(sum, w, epsilon); },
              Lobes{{"1.5", "2", "0.0625"}}, 4},
  };
}

template <class T, class F>
auto evaluate(const Formula<F>& formula, const std::vector<const char*>& a) {
  const auto arg = [&](std::size_t i) { return constant<T>(a[i]); };
  if constexpr (std::invocable<F, T>) {
    return formula.call(arg(0));
  } else if constexpr (std::invocable<F, T, T>) {
    return formula.call(arg(0), arg(1));
  } else if constexpr (std::invocable<F, T, T, T>) {
    return formula.call(arg(0), arg(1), arg(2));
  } else {
    return formula.call(arg(0), arg(1), arg(2), arg(3));
  }
}

template <class T>
Decimal50 value_of(const T& x) {
  return Decimal50(x);
}
Decimal50 value_of(Eigen::half x) {
  return Decimal50(static_cast<float>(x));
}
Decimal50 value_of(HalfResult x) {
  return Decimal50(static_cast<double>(x));
}
template <class T, int N>
Decimal50 value_of(const ceres::Jet<T, N>& x) {
  return value_of(x.a);
}

template <class T>
double epsilon_of() {
  if constexpr (std::same_as<T, Eigen::half> || std::same_as<T, HalfResult>) {
    return 0x1p-10;
  } else if constexpr (requires { typename T::Scalar; }) {
    return epsilon_of<typename T::Scalar>();
  } else {
    return static_cast<double>(std::numeric_limits<T>::epsilon());
  }
}

std::string describe(const char* name, const std::vector<const char*>& arguments) {
  std::string text = name;
  for (const char* a : arguments) text += std::string(" ") + a;
  return text;
}

template <class T>
class EveryScalar : public ::testing::Test {};

using Jet1 = ceres::Jet<double, 1>;
using NestedJet = ceres::Jet<ceres::Jet<double, 2>, 2>;
using WideNestedJet = ceres::Jet<ceres::Jet<long double, 1>, 1>;
using ScalarTypes = ::testing::Types<float, double, long double, Eigen::half, HalfResult, Decimal50, Jet1,
                                     NestedJet, WideNestedJet>;
struct ScalarNames {
  template <class T>
  static std::string GetName(int i) {
    constexpr const char* names[] = {"Float",     "Double", "LongDouble", "Half",         "HalfResult",
                                     "Decimal50", "Jet",    "NestedJet",  "WideNestedJet"};
    return names[i];
  }
};
TYPED_TEST_SUITE(EveryScalar, ScalarTypes, ScalarNames);

TYPED_TEST(EveryScalar, KeepsItsTypeAndAgreesWithFiftyDigits) {
  const auto check = [](const auto& formula) {
    for (const auto& arguments : formula.arguments) {
      const auto computed = evaluate<TypeParam>(formula, arguments);
      static_assert(std::same_as<std::remove_const_t<decltype(computed)>, TypeParam>,
                    "a formula left its scalar");
      // Truth is the same formula in 100 digits; that the formula itself is right, other tests say.
      const Decimal50 truth(evaluate<Decimal100>(formula, arguments));
      const double epsilon =
          std::max(epsilon_of<TypeParam>(), static_cast<double>(std::numeric_limits<Decimal50>::epsilon()));
      EXPECT_TRUE(
          is_close(describe(formula.name, arguments), truth, value_of(computed), formula.epsilons * epsilon));
    }
  };
  std::apply([&](const auto&... formula) { (check(formula), ...); }, formulas());
}

// A formula that went through its own expression is the formula.
TEST(SymbolicScalar, EveryFormulaIsItsExpression) {
  const auto check = [](const auto& formula) {
    for (const auto& arguments : formula.arguments) {
      const auto expression = evaluate<Symbolic>(formula, arguments);
      static_assert(std::same_as<std::remove_const_t<decltype(expression)>, Symbolic>,
                    "a formula left its scalar");
      const auto no_variable = [](const std::string& name) -> Decimal100 { throw std::logic_error(name); };
      EXPECT_EQ(shadefit::evaluate<Decimal100>(expression, no_variable),
                evaluate<Decimal100>(formula, arguments))
          << describe(formula.name, arguments) << ": " << to_text(expression);
      EXPECT_EQ(count_operations(expression), Operations{}) << "all of it is numbers";
      EXPECT_FALSE(to_latex(expression).empty());
    }
  };
  std::apply([&](const auto&... formula) { (check(formula), ...); }, formulas());
}

TEST(IntervalScalar, EveryFormulaContainsTheTruth) {
  const auto check = [](const auto& formula) {
    for (const auto& arguments : formula.arguments) {
      const auto computed = evaluate<Interval>(formula, arguments);
      static_assert(std::same_as<std::remove_const_t<decltype(computed)>, Interval>,
                    "a formula left its scalar");
      const auto truth = evaluate<Decimal100>(formula, arguments);
      EXPECT_TRUE(contains(computed, truth)) << describe(formula.name, arguments);
      // and says something: 40 digits of relative width
      EXPECT_LE(end(computed, true) - end(computed, false), abs(truth) * 1e-40)
          << describe(formula.name, arguments);
    }
  };
  std::apply([&](const auto&... formula) { (check(formula), ...); }, formulas());
}

TEST(DecimalText, IsConvertedPerScalarNotThroughDouble) {
  EXPECT_EQ(constant<float>("0.1"), 0.1F);
  EXPECT_EQ(constant<long double>("0.1"), 0.1L);
  EXPECT_NE(constant<long double>("0.1"), static_cast<long double>(constant<double>("0.1")));
  EXPECT_EQ(constant<Decimal50>("0.1"), Decimal50(1) / 10);
  EXPECT_EQ(static_cast<float>(constant<Eigen::half>("0.1")), 0.0999755859375F);
  EXPECT_THROW(constant<double>("0.1x"), std::invalid_argument);
  EXPECT_THROW(constant<double>(""), std::invalid_argument);
}

TEST(Half, IsRoundedOnce) {
  // Just above the tie between 1 and the next half: through float the excess is lost and the tie goes to
  // even.
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 0x1p-11 + 0x1p-40)), 1 + 0x1p-10F);
  EXPECT_EQ(static_cast<float>(Eigen::half(static_cast<float>(1 + 0x1p-11 + 0x1p-40))), 1.0F);
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 0x1p-11)), 1.0F) << "a tie goes to even";
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 3 * 0x1p-11)), 1 + 0x1p-9F);
  EXPECT_EQ(static_cast<float>(round_to_half(1 + 0x1p-11 - 0x1p-40)), 1.0F);
  EXPECT_EQ(static_cast<float>(round_to_half(-1 - 0x1p-11 - 0x1p-40)), -1 - 0x1p-10F);
  EXPECT_TRUE(std::isinf(static_cast<float>(round_to_half(65520))));
  EXPECT_EQ(static_cast<float>(round_to_half(65519.999)), 65504.0F);
}

TEST(Vocabulary, SelectsClampsAndPowers) {
  EXPECT_EQ(min(1.0, 2.0), 1);
  EXPECT_EQ(min(2.0, 1.0), 1);
  EXPECT_EQ(max(1.0, 2.0), 2);
  EXPECT_EQ(max(2.0, 1.0), 2);
  EXPECT_EQ(positive_part(-1.0), 0);
  EXPECT_EQ(positive_part(0.5), 0.5);
  EXPECT_EQ(select(less(1.0, 2.0), 3.0, 4.0), 3);
  EXPECT_EQ(select(less(2.0, 2.0), 3.0, 4.0), 4);
  EXPECT_EQ(power(0.0, 2.5), 0);
  EXPECT_EQ(power(Decimal50(0), Decimal50("2.5")), 0);
  for (int n = -9; n <= 9; ++n) EXPECT_EQ(power(2.0, n), std::ldexp(1.0, n)) << n;
  EXPECT_EQ(power(0.0, 0), 1);
}

TEST(Log1pRemainder, KeepsItsDigitsOnBothSidesOfItsBranch) {
  std::vector<double> places{-1 + 0x1p-40, -0.999, -0.75, 0.75, 1, 3, 1e-300, -1e-300, 1e-8, -1e-8};
  for (double x = -0.6; x <= 0.6; x += 0.0123) places.push_back(x);
  for (const double edge : {-0.5, 0.5}) {
    for (const double towards : {-1.0, 1.0}) places.push_back(std::nextafter(edge, towards));
    places.push_back(edge);
  }
  for (const double x : places) {
    const Decimal50 truth = Decimal50(log1p(Decimal100(x)) - Decimal100(x));
    if (x * x < std::numeric_limits<double>::min()) {
      EXPECT_EQ(log1p_remainder(x), -0.0) << "below x^2/2's range";
      continue;
    }
    // Near x = -1 the rounding of log1p itself shows; elsewhere two to three roundings, and in long double
    // the one of a tail that is summed in double.
    EXPECT_TRUE(is_close(std::to_string(x), truth, Decimal50(log1p_remainder(x)),
                         6 * std::numeric_limits<double>::epsilon()));
    EXPECT_TRUE(is_close(std::to_string(x), truth, Decimal50(log1p_remainder(static_cast<long double>(x))),
                         6 * static_cast<double>(std::numeric_limits<long double>::epsilon())));
    EXPECT_TRUE(is_close(std::to_string(x), truth, log1p_remainder(Decimal50(x)), 1e-48));
  }
  EXPECT_TRUE(std::isinf(log1p_remainder(-1.0)));
}

}  // namespace
}  // namespace shadefit
