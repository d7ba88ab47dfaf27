#pragma once

#include <array>
#include "approx/arithmetic.hpp"
#include "approx/encoding.hpp"
#include "approx/fresnel.hpp"
#include "approx/full_range.hpp"
#include "approx/gloss.hpp"
#include "approx/material.hpp"
#include "approx/microfacet.hpp"
#include "approx/normalisation.hpp"
#include "approx/phase.hpp"
#include "approx/reflectance.hpp"
#include "approx/shading.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of Fresnel's formulas and their stand-ins.
template <class Visit>
void fresnel_formulas(const Visit& visit) {
  const Rows cosines{{"0.25"}, {"0.5"}, {"0.9375"}};
  visit(Formula{"grazing_power", [](auto c) { return grazing_power(c, 4); }, cosines, 8});
  visit(
      Formula{OF(schlick_reflectance_of_gloss), Rows{{"0.0625", "0.5", "0.25"}, {"0.5", "0.25", "0.25"}}, 4});
  visit(Formula{OF(schlick_weight), cosines, 8});
  visit(Formula{OF(schlick_reflectance), Rows{{"0.0625", "0.5"}}, 4});
  visit(Formula{OF(reflectance_at_normal), Rows{{"1.5"}, {"0.5"}}, 8});
  visit(Formula{OF(dielectric_reflectance), Rows{{"0.25", "1.5"}, {"0.875", "2"}, {"0.875", "0.75"}}, 64});
  visit(Formula{OF(conductor_reflectance_at_normal), Rows{{"1.5", "0"}, {"0.25", "3.5"}}, 16});
  visit(Formula{OF(conductor_reflectance),
                Rows{{"0.25", "1.5", "0.5"}, {"0.875", "0.25", "3.5"}, {"0.5", "1.5", "7.5"}}, 128});
  visit(Formula{OF(weight_of_reflectance), Rows{{"0.75", "0.5"}}, 4});
  visit(Formula{OF(fresnel_one_term), Rows{{"0.25", "8"}, {"0.5", "8.5"}}, 16});
  visit(Formula{OF(fresnel_quadratic), Rows{{"0.25", "-5.5", "-7"}, {"0.5", "-5.5", "-7"}}, 16});
  visit(Formula{OF(fresnel_cubic), Rows{{"0.25", "-5.5", "-2.5", "-7"}, {"0.5", "-5.5", "-2.5", "-7"}}, 16});
  visit(Formula{OF(fresnel_quartic),
                Rows{{"0.25", "-7", "0.5", "-4", "-7"}, {"0.5", "-7", "0.5", "-4", "-7"}}, 16});
  visit(Formula{OF(fresnel_fourth), Rows{{"0.25", "0.75"}, {"0.5", "1"}}, 8});
  visit(Formula{OF(fresnel_square), Rows{{"0.25", "2", "-2.75"}, {"0.5", "2", "-2.75"}}, 16});
  visit(Formula{OF(fresnel_rational), Rows{{"0.25", "1.25"}, {"0.5", "1.25"}}, 8});
}

/// Of normalised lobes.
template <class Visit>
void normalisation_formulas(const Visit& visit) {
  visit(Formula{"LambertLobe::constant", [](auto a) { return LambertLobe::constant(a); }, Rows{{"1"}}, 4});
  visit(
      Formula{"PhongLobe::constant", [](auto a) { return PhongLobe::constant(a); }, Rows{{"0.5"}, {"8"}}, 4});
  visit(Formula{"PhongBrdfLobe::lobe", [](auto y, auto a) { return PhongBrdfLobe::lobe(y, a); },
                Rows{{"0.25", "8"}}, 16});
  visit(Formula{"PhongBrdfLobe::constant", [](auto a) { return PhongBrdfLobe::constant(a); },
                Rows{{"0.5"}, {"8"}}, 4});
  visit(Formula{"BlinnPhongLobe::constant", [](auto a) { return BlinnPhongLobe::constant(a); },
                Rows{{"0.5"}, {"8"}}, 8});
  visit(Formula{"BlinnPhongBrdfLobe::lobe", [](auto y, auto a) { return BlinnPhongBrdfLobe::lobe(y, a); },
                Rows{{"0.25", "8"}}, 16});
  visit(Formula{"BlinnPhongBrdfLobe::constant", [](auto a) { return BlinnPhongBrdfLobe::constant(a); },
                Rows{{"0.5"}, {"8"}}, 8});
  visit(Formula{"BlinnPhongCheapLobe::constant", [](auto a) { return BlinnPhongCheapLobe::constant(a); },
                Rows{{"0.5"}, {"8"}}, 4});
  visit(Formula{"MicrofacetLobe::lobe", [](auto y, auto a) { return MicrofacetLobe::lobe(y, a); },
                Rows{{"0.25", "8"}}, 16});
  visit(Formula{"MicrofacetLobe::constant", [](auto a) { return MicrofacetLobe::constant(a); },
                Rows{{"0.5"}, {"8"}}, 4});
}

/// Of the parts of a directional reflectance.
template <class Visit>
void reflectance_formulas(const Visit& visit) {
  const Rows arcs{{"0.5", "0.75", "1"}, {"0.5", "-0.25", "3"}};
  // y, a, the view angle and the end of the arc; and g, a, the view's elevation and the latitudes' integral
  const Rows circles{{"0.25", "5", "0.5", "2"}, {"0.5", "8", "1", "1.5"}};
  const Rows longitudes{{"0.5", "5", "0.25"}, {"1", "8", "1"}};
  const Rows meridians{{"0.5", "5", "0.25", "0.5"}, {"1", "8", "1", "0.25"}};
  visit(Formula{"arc_of_line", [](auto p, auto q, auto phi) { return arc_of_line(p, q, arc_to(phi)); }, arcs,
                16});
  visit(Formula{"arc_of_square", [](auto p, auto q, auto phi) { return arc_of_square(p, q, arc_to(phi)); },
                arcs, 16});
  visit(Formula{"phong_circle.plain",
                [](auto y, auto a, auto view, auto phi) {
                  return phong_circle(y, a, direction_of(view), arc_to(phi)).plain;
                },
                circles, 32});
  visit(Formula{"phong_circle.with_cosine",
                [](auto y, auto a, auto view, auto phi) {
                  return phong_circle(y, a, direction_of(view), arc_to(phi)).with_cosine;
                },
                circles, 32});
  visit(Formula{"blinn_phong_circle.plain",
                [](auto y, auto a, auto view, auto phi) {
                  return blinn_phong_circle(y, a, direction_of(view), arc_to(phi)).plain;
                },
                circles, 32});
  visit(Formula{"blinn_phong_circle.with_cosine",
                [](auto y, auto a, auto view, auto phi) {
                  return blinn_phong_circle(y, a, direction_of(view), arc_to(phi)).with_cosine;
                },
                circles, 64});
  visit(Formula{OF(cosine_power), Rows{{"0.25", "5"}, {"-1", "8"}}, 32});
  visit(Formula{PART_OF(phong_longitude, plain), longitudes, 32});
  visit(Formula{PART_OF(phong_longitude, with_cosine), longitudes, 32});
  visit(Formula{PART_OF(phong_latitude, plain), Rows{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{PART_OF(phong_latitude, with_cosine), Rows{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{OF(blinn_phong_longitude), longitudes, 32});
  visit(Formula{OF(horizon_latitude), Rows{{"0.5", "0.25"}, {"1", "1"}}, 16});
  visit(Formula{PART_OF(blinn_phong_latitude, one), Rows{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{PART_OF(blinn_phong_latitude, z_squared), Rows{{"0.25", "5"}, {"-0.5", "8"}}, 16});
  visit(Formula{"blinn_phong_meridian.plain",
                [](auto g, auto a, auto e, auto one) {
                  return blinn_phong_meridian(g, a, e, {one, one * one}).plain;
                },
                meridians, 32});
  visit(Formula{"blinn_phong_meridian.with_cosine",
                [](auto g, auto a, auto e, auto one) {
                  return blinn_phong_meridian(g, a, e, {one, one * one}).with_cosine;
                },
                meridians, 64});
}

/// Of a scene's shading.
template <class Visit>
void shading_formulas(const Visit& visit) {
  const Rows slopes{{"0.9375", "5", "-2.5"}, {"0.5", "4", "-1.5"}};
  visit(Formula{"log2_by_slopes",
                [](auto y, auto a, auto b) {
                  return log2_by_slopes(y, std::array{a, b});
                },
                Rows{{"-0.25", "1.5", "-0.75"}}, 8});
  visit(Formula{"sloped_lobe",
                [](auto c, auto a, auto b) {
                  return sloped_lobe(c, std::array{a, b});
                },
                slopes, 16});
  visit(Formula{"sloped_lobe of an exponent",
                [](auto c, auto n, auto s) { return sloped_lobe(c, n, std::array{s}); },
                Rows{{"0.9375", "5", "1.5"}}, 16});
  visit(Formula{OF(reflectance_between), Rows{{"0.0625", "0.75", "0.5"}}, 8});
  visit(Formula{OF(shown_specular), Rows{{"0.25", "3", "0.5", "0.875"}, {"0.75", "4", "0.5", "0.875"}}, 8});
}

/// Of microfacets.
template <class Visit>
void microfacet_formulas(const Visit& visit) {
  // cos^2 of the angle between m and n, and alpha; 1 is the limit of GTR1
  const Rows microfacets{{"0.75", "0.5"}, {"0.25", "0.75"}, {"0.5", "1"}};
  visit(Formula{OF(erfc), Rows{{"-0.5"}, {"0"}, {"1.5"}}, 16});
  visit(Formula{OF(blinn_phong_exponent), Rows{{"0.5"}, {"0.75"}}, 8});
  visit(Formula{"blinn_phong_distribution",
                [](auto c, auto a) { return blinn_phong_distribution(normal_of(c), a); }, microfacets, 32});
  visit(Formula{"beckmann_distribution",
                [](auto c, auto a) { return beckmann_distribution(normal_of(c), a); }, microfacets, 32});
  visit(Formula{"ggx_distribution", [](auto c, auto a) { return ggx_distribution(normal_of(c), a); },
                microfacets, 16});
  visit(Formula{"gtr1_distribution", [](auto c, auto a) { return gtr1_distribution(normal_of(c), a); },
                microfacets, 16});
  visit(Formula{OF(beckmann_lambda), Rows{{"0.5"}, {"4"}}, 128});
  visit(Formula{OF(ggx_lambda), Rows{{"0.0625"}, {"0.5"}, {"4"}}, 16});
  visit(Formula{OF(smith_masking), Rows{{"0.5"}}, 4});
  visit(Formula{"facing_circle",
                [](auto view, auto normal, auto phi) {
                  return facing_circle(direction_of(view), direction_of(normal), arc_to(phi));
                },
                Rows{{"0.5", "0.25", "3"}, {"1", "1", "2"}}, 16});
}

/// Of encodings, materials, volumes.
template <class Visit>
void material_formulas(const Visit& visit) {
  const Rows scatterings{{"0.5", "0.25"}, {"0.25", "-0.5"}, {"1", "0"}};
  visit(Formula{OF(srgb_code), Rows{{"0.5"}, {"1.5"}}, 16});
  visit(Formula{OF(srgb_encode), Rows{{"0.001953125"}, {"0.5"}, {"1"}}, 16});
  visit(Formula{OF(srgb_decode), Rows{{"0.03125"}, {"0.5"}, {"1"}}, 16});
  visit(Formula{OF(metallic_f0), Rows{{"0.03125", "0.75", "0.25"}}, 4});
  visit(Formula{OF(henyey_greenstein), scatterings, 32});
}

/// Of the forms that hold for every argument.
template <class Visit>
void full_range_formulas(const Visit& visit) {
  visit(Formula{OF(power_lobe_of_dot), Rows{{"0.875", "5"}}, 16});
  visit(Formula{OF(power_by_exp2_of_dot), Rows{{"0.875", "5"}}, 16});
  visit(Formula{OF(gaussian_lobe_base_two_of_dot), Rows{{"0.75", "7"}}, 16});
  visit(Formula{OF(schlick_weight_of_dot), Rows{{"0.25"}}, 16});
  visit(Formula{OF(decode_clamped_gloss), Rows{{"0.25", "10", "1"}}, 16});
  visit(Formula{OF(von_mises_fisher_of_any_concentration), Rows{{"0.25", "5"}, {"1.5", "0.125"}}, 32});
  visit(Formula{OF(henyey_greenstein_from_both_sides), Rows{{"0.25", "0.75"}, {"1.5", "-0.5"}}, 32});
  visit(Formula{OF(blinn_phong_brdf_constant_by_parts), Rows{{"8"}}, 32});
}

}  // namespace shadefit::testing
