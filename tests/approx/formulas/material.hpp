#pragma once

#include "approx/dither.hpp"
#include "approx/encoding.hpp"
#include "approx/material.hpp"
#include "approx/phase.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of encodings, materials, volumes.
template <class Visit>
void material_formulas(const Visit& visit) {
  using Lobes = Arguments;
  const Lobes factors{{"0.25", "0.5", "0.03125"}};
  const Lobes scatterings{{"0.5", "0.25"}, {"0.25", "-0.5"}, {"1", "0"}};
  visit(Formula{"srgb_code", [](auto x) { return srgb_code(x); }, Lobes{{"0.5"}, {"1.5"}}, 16});
  visit(Formula{"srgb_encode", [](auto x) { return srgb_encode(x); }, Lobes{{"0.001953125"}, {"0.5"}, {"1"}},
                16});
  visit(
      Formula{"srgb_decode", [](auto x) { return srgb_decode(x); }, Lobes{{"0.03125"}, {"0.5"}, {"1"}}, 16});
  visit(Formula{"gamma_encode", [](auto x, auto g) { return gamma_encode(x, g); },
                Lobes{{"0.25", "2.25"}, {"1", "2.25"}}, 8});
  visit(Formula{"gamma_decode", [](auto x, auto g) { return gamma_decode(x, g); },
                Lobes{{"0.25", "2.25"}, {"1", "2.25"}}, 8});
  visit(Formula{"metallic_albedo", [](auto c, auto m) { return metallic_albedo(c, m); },
                Lobes{{"0.75", "0.25"}}, 4});
  visit(Formula{"metallic_f0", [](auto f, auto c, auto m) { return metallic_f0(f, c, m); },
                Lobes{{"0.03125", "0.75", "0.25"}}, 4});
  visit(Formula{"brightest_base_colour", [](auto f, auto m) { return brightest_base_colour(f, m); },
                Lobes{{"0.03125", "0.25"}}, 4});
  visit(Formula{"mean_schlick_reflectance", [](auto f) { return mean_schlick_reflectance(f); },
                Lobes{{"0.03125"}, {"0.5"}}, 4});
  visit(Formula{"TransmittedBothWays",
                [](auto i, auto o, auto f) { return TransmittedBothWays::factor(i, o, f); }, factors, 4});
  visit(Formula{"TransmittedIn", [](auto i, auto o, auto f) { return TransmittedIn::factor(i, o, f); },
                factors, 4});
  visit(Formula{"TransmittedAtNormal",
                [](auto i, auto o, auto f) { return TransmittedAtNormal::factor(i, o, f); }, factors, 4});
  visit(Formula{"Unattenuated", [](auto i, auto o, auto f) { return Unattenuated::factor(i, o, f); }, factors,
                4});
  visit(
      Formula{"henyey_greenstein", [](auto c, auto g) { return henyey_greenstein(c, g); }, scatterings, 32});
  visit(Formula{"henyey_greenstein_near_peak",
                [](auto y, auto g) { return henyey_greenstein_near_peak(y, g); }, scatterings, 32});
  visit(Formula{"henyey_greenstein_within", [](auto y, auto g) { return henyey_greenstein_within(y, g); },
                scatterings, 32});
  visit(Formula{"march_rms", [](auto n) { return march_rms(n); }, Lobes{{"10"}, {"100"}}, 4});
  visit(Formula{"march_rms_at_offset", [](auto n, auto d) { return march_rms_at_offset(n, d); },
                Lobes{{"10", "0.25"}, {"100", "0"}}, 8});
  visit(Formula{"depth_weight", [](auto gap, auto falloff) { return depth_weight(gap, falloff); },
                Lobes{{"2", "0.0625"}}, 4});
  visit(Formula{"guarded_mean", [](auto sum, auto w, auto epsilon) { return guarded_mean(sum, w, epsilon); },
                Lobes{{"1.5", "2", "0.0625"}}, 4});
}

}  // namespace shadefit::testing
