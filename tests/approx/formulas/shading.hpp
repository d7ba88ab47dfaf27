#pragma once

#include <array>

#include "approx/arithmetic.hpp"
#include "approx/gloss.hpp"
#include "approx/shading.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of a scene's shading.
template <class Visit>
void shading_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes slopes{{"0.9375", "5", "-2.5"}, {"0.5", "4", "-1.5"}};
  visit(Formula{"log2_by_slopes",
                [](auto y, auto a, auto b) {
                  return log2_by_slopes(y, std::array{a, b});
                },
                Lobes{{"-0.25", "1.5", "-0.75"}}, 8});
  visit(Formula{"sloped_lobe",
                [](auto c, auto a, auto b) {
                  return sloped_lobe(c, std::array{a, b});
                },
                slopes, 16});
  visit(Formula{"sloped_lobe of an exponent",
                [](auto c, auto n, auto s) { return sloped_lobe(c, n, std::array{s}); },
                Lobes{{"0.9375", "5", "1.5"}}, 16});
  visit(Formula{"gaussian_exponent_base_two", [](auto c, auto m) { return gaussian_exponent_base_two(c, m); },
                Lobes{{"0.75", "7"}}, 16});
  visit(Formula{"power_exponent_base_two", [](auto c, auto k) { return power_exponent_base_two(c, k); },
                Lobes{{"0.75", "7"}}, 8});
  visit(Formula{"reflectance_between",
                [](auto f0, auto f90, auto w) { return reflectance_between(f0, f90, w); },
                Lobes{{"0.0625", "0.75", "0.5"}}, 8});
  visit(Formula{"shown_specular", [](auto f, auto g, auto t, auto l) { return shown_specular(f, g, t, l); },
                Lobes{{"0.25", "3", "0.5", "0.875"}, {"0.75", "4", "0.5", "0.875"}}, 8});
}

}  // namespace shadefit::testing
