#pragma once

#include <array>

#include "approx/material.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Materials.
namespace shadefit {

inline constexpr std::array material_claims{
    Claim{.id = "chart-dielectric",
          .statement = "the chart's sRGB codes 40 to 75, for dielectrics, are 0.017 to 0.067 in linear light",
          .printed = {{"from", "0.017"}, {"to", "0.067"}},
          .inputs = {{"from code", "40"},
                     {"to code", "75"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation =
              "The chart's texture is sRGB-encoded and a GPU decodes it so (IEC 61966-2-1). Each code is "
              "decoded by that function and by a plain power, which is most wrong for dark values. The "
              "exponents for which a power of code/255 rounds to both printed numbers follow from "
              "log(printed -+ half a digit)/log(code/255). Code/256 is the common slip of dividing by the "
              "number of codes.",
          .source = sources::lagarde_2012_chart},
    Claim{.id = "chart-metal",
          .statement = "the chart's sRGB codes 155 to 255, for metals, are 0.33 to 1.0 in linear light",
          .printed = {{"from", "0.33"}, {"to", "1.0"}},
          .inputs = {{"from code", "155"},
                     {"to code", "255"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation =
              "Decoded as for chart-dielectric. For bright values the functions are so close that two digits "
              "cannot tell them apart.",
          .source = sources::lagarde_2012_chart},
    Claim{
        .id = "chart-range-typo",
        .statement =
            "the linear range of the specular of dielectrics ends at 0.063 where it is remapped to `[0, 1]`; "
            "the same source gives 0.067 where materials are explained",
        .printed = {{"first", "0.067"}, {"second", "0.063"}},
        .inputs = {{"code", "75"},
                   {"convention", chart_convention},
                   {"other conventions", other_chart_conventions}},
        .derivation =
            "The second number is judged against the first. Both are the upper end of the same chart, code "
            "75. This code tells which of them is meant; the code of each number is shown too.",
        .source = sources::pestana_workflows_2014},
    Claim{.id = "chart-overlap",
          .statement =
              "the chart's ranges contain the ranges of common materials: dielectrics of 0.02 to 0.05 within "
              "codes "
              "40 to 75, metals of 0.5 to 1 within codes 155 to 255",
          .inputs = {{"dielectric codes", "40, 75"},
                     {"common dielectrics", "0.02, 0.05"},
                     {"metal codes", "155, 255"},
                     {"common metals", "0.5, 1"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation =
              "The chart's codes, decoded, are intervals of linear reflectance. The chart speaks of overlap. "
              "We read it as: the interval holds all of the materials, as artists have to stay within it. "
              "Whether the intervals overlap is shown too.",
          .source = sources::lagarde_2012_chart},
    Claim{.id = "middle-grey",
          .statement = "in sRGB, middle grey (half of the linear light of white) is code 187, not 128",
          .printed = {{"code", "187"}},
          .inputs = {{"linear", "0.5"},
                     {"not", "128"},
                     {"photographic grey", "0.18"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation =
              "Middle grey is read as half of the light, which code 187 is close to. The grey card of "
              "photography, 18 % of the light, is a different grey; its code is shown too.",
          .source = sources::lagarde_2011_feeding},
    Claim{.id = "metallic-workflow",
          .statement =
              "the metallic workflow's albedo `(1-m) c` and specular `F0 = lerp(0.03, c, m)`, for a base "
              "colour `c` and metallic `m`, reflect no more than comes in: `albedo + F0 <= 1`",
          .printed = {{"F0 of dielectrics", "0.03"}},
          .inputs = {{"codes", "256"}},
          .derivation =
              "(1-m) c + 0.03 (1-m) + c m = c + 0.03 (1-m): linear in both, so the region above 1 is a "
              "triangle at the corner c = 1, m = 0. The sum is also computed for every pair of 8-bit codes, "
              "with the colour sRGB-encoded and metallic linear.",
          .source = sources::pestana_workflows_2014},
    Claim{.id = "workflow-channels",
          .statement = "the specular workflow stores 7 channels, the metallic workflow 5",
          .printed = {{"specular", "7"}, {"metallic", "5"}},
          .inputs = {{"specular maps", "albedo 3, specular 3, roughness 1"},
                     {"metallic maps", "base colour 3, metallic 1, roughness 1"},
                     {"one more map", "specular of dielectrics 1"}},
          .derivation = "The channels of each workflow's maps, added up: a colour has three.",
          .source = sources::pestana_workflows_2014},
    Claim{.id = "diffuse-fresnel",
          .statement =
              "a Lambertian term times `(1-F_i)(1-F_o)`, or times its cheaper stand-in `1-F0`, keeps "
              "`specular + diffuse <= 1` at every angle (`F_i`, `F_o`: Fresnel towards light and view)",
          .inputs = {{"factor", TransmittedBothWays::name},
                     {"stand-in", TransmittedAtNormal::name},
                     {"beside", TransmittedIn::name},
                     {"albedo", "1"},
                     {"f0", "0.04"}},
          .derivation =
              "Light from one direction: F_i of it is mirrored, and the diffuse term sends out albedo times "
              "the mean of the factor over the hemisphere of views, weighted by the cosine. F is Schlick's. "
              "(1-F_i)(1-F_o) has the mean (1-F_i)(1-f0) 20/21, so the sum stays below 1 for every f0 up to "
              "grazing light, where F_i = 1. With 1-F0 and albedo a the sum f0 + (1-f0) w + a (1-f0), w = "
              "(1-c)^5, is at most 1 where w <= 1-a. Every factor is linear in F_i, so the extremes lie at "
              "normal and at grazing light. Light and view exchanged (light from everywhere, seen from one "
              "direction) is judged as well.",
          .source = sources::lagarde_2011_adopting},
};

}  // namespace shadefit
