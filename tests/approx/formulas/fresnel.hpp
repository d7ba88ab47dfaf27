#pragma once

#include "approx/fresnel.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of Fresnel's formulas and their stand-ins.
template <class Visit>
void fresnel_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes cosines{{"0.25"}, {"0.5"}, {"0.9375"}};
  visit(Formula{"grazing_power", [](auto c) { return grazing_power(c, 4); }, cosines, 8});
  visit(Formula{"fresnel_quadratic_exponent",
                [](auto c, auto a, auto b) { return fresnel_quadratic_exponent(c, a, b); },
                Lobes{{"0.5", "-5.5", "-7"}}, 4});
  visit(Formula{"schlick_reflectance_of_gloss",
                [](auto f, auto g, auto w) { return schlick_reflectance_of_gloss(f, g, w); },
                Lobes{{"0.0625", "0.5", "0.25"}, {"0.5", "0.25", "0.25"}}, 4});
  visit(Formula{"schlick_weight", [](auto c) { return schlick_weight(c); }, cosines, 8});
  visit(Formula{"schlick_reflectance", [](auto f, auto w) { return schlick_reflectance(f, w); },
                Lobes{{"0.0625", "0.5"}}, 4});
  visit(Formula{"reflectance_at_normal", [](auto n) { return reflectance_at_normal(n); },
                Lobes{{"1.5"}, {"0.5"}}, 8});
  visit(Formula{"dielectric_reflectance", [](auto c, auto n) { return dielectric_reflectance(c, n); },
                Lobes{{"0.25", "1.5"}, {"0.875", "2"}, {"0.875", "0.75"}}, 64});
  visit(Formula{"conductor_reflectance_at_normal",
                [](auto n, auto k) { return conductor_reflectance_at_normal(n, k); },
                Lobes{{"1.5", "0"}, {"0.25", "3.5"}}, 16});
  visit(Formula{"conductor_reflectance",
                [](auto c, auto n, auto k) { return conductor_reflectance(c, n, k); },
                Lobes{{"0.25", "1.5", "0.5"}, {"0.875", "0.25", "3.5"}, {"0.5", "1.5", "7.5"}}, 128});
  visit(Formula{"weight_of_reflectance", [](auto f, auto f0) { return weight_of_reflectance(f, f0); },
                Lobes{{"0.75", "0.5"}}, 4});
  visit(Formula{"fresnel_one_term", [](auto c, auto a) { return fresnel_one_term(c, a); },
                Lobes{{"0.25", "8"}, {"0.5", "8.5"}}, 16});
  visit(Formula{"fresnel_quadratic", [](auto c, auto a, auto b) { return fresnel_quadratic(c, a, b); },
                Lobes{{"0.25", "-5.5", "-7"}, {"0.5", "-5.5", "-7"}}, 16});
  visit(Formula{"fresnel_cubic", [](auto c, auto a, auto b, auto d) { return fresnel_cubic(c, a, b, d); },
                Lobes{{"0.25", "-5.5", "-2.5", "-7"}, {"0.5", "-5.5", "-2.5", "-7"}}, 16});
  visit(Formula{"fresnel_quartic",
                [](auto c, auto a, auto b, auto d, auto g) { return fresnel_quartic(c, a, b, d, g); },
                Lobes{{"0.25", "-7", "0.5", "-4", "-7"}, {"0.5", "-7", "0.5", "-4", "-7"}}, 16});
  visit(Formula{"fresnel_fourth", [](auto c, auto s) { return fresnel_fourth(c, s); },
                Lobes{{"0.25", "0.75"}, {"0.5", "1"}}, 8});
  visit(Formula{"fresnel_square", [](auto c, auto a, auto b) { return fresnel_square(c, a, b); },
                Lobes{{"0.25", "2", "-2.75"}, {"0.5", "2", "-2.75"}}, 16});
  visit(Formula{"fresnel_rational", [](auto c, auto a) { return fresnel_rational(c, a); },
                Lobes{{"0.25", "1.25"}, {"0.5", "1.25"}}, 8});
  visit(
      Formula{"one_term_sharpness", [](auto x) { return one_term_sharpness(x); }, Lobes{{"0.75"}, {"1"}}, 4});
}

}  // namespace shadefit::testing
