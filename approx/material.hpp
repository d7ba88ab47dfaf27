#pragma once

#include <array>
#include <string_view>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Materials: colour charts, metals and dielectrics, and the energy that a workflow keeps. Colours, albedos
/// and reflectances are linear, one channel, in [0, 1].
namespace shadefit {

/// The albedo of the metallic workflow: c - c m, for the base colour c and metallic m in [0, 1].
/// Source: Pestana 2014, "Physically Based Shading, Metallic and Specular workflows".
template <class T>
T metallic_albedo(const T& base_colour, const T& metallic) {
  return base_colour - base_colour * metallic;
}

/// The reflectance at normal incidence of the metallic workflow: from that of every dielectric (m = 0) to the
/// base colour c (m = 1), in a line. Source: as above.
template <class T>
T metallic_f0(const T& dielectric_f0, const T& base_colour, const T& metallic) {
  return dielectric_f0 + metallic * (base_colour - dielectric_f0);
}

/// The brightest base colour that keeps albedo + F0 <= 1: their sum is c (1-m) + f0 (1-m) + c m = c + f0
/// (1-m), so 1 - f0 (1-m).
template <class T>
T brightest_base_colour(const T& dielectric_f0, const T& metallic) {
  const T one = integer<T>(1);
  return one - dielectric_f0 * (one - metallic);
}

/// The mean of Schlick's F = f0 + (1-f0)(1-c)^5 over a hemisphere of uniform light, weighted by the cosine:
/// the integral of (1-c)^5 2c dc is 2 B(2, 6) = 2 * 1! 5!/7! = 1/21, so f0 + (1-f0)/21.
template <class T>
T mean_schlick_reflectance(const T& f0) {
  return f0 + (integer<T>(1) - f0) / integer<T>(21);
}

// What a Lambertian term under a mirror-like surface may be multiplied by, so that both together reflect no
// more than comes in. F_i and F_o are the surface's reflectances towards the light and the view, f0 that at
// normal incidence. All named as the records write them.

/// (1-F_i)(1-F_o): what gets in times what of it gets out again. Reciprocal.
/// Source: Shirley, Smits, Hu, Lafortune 1997, "A Practitioners' Assessment of Light Reflection Models".
struct TransmittedBothWays {
  static constexpr std::string_view name = "(1-F_i)(1-F_o)";
  template <class T>
  static T factor(const T& f_in, const T& f_out, const T&) {
    return (integer<T>(1) - f_in) * (integer<T>(1) - f_out);
  }
};

/// 1-F_i: what gets in. Not reciprocal.
struct TransmittedIn {
  static constexpr std::string_view name = "1-F_i";
  template <class T>
  static T factor(const T& f_in, const T&, const T&) {
    return integer<T>(1) - f_in;
  }
};

/// 1-F0: what gets in at normal incidence. Reciprocal, and free.
struct TransmittedAtNormal {
  static constexpr std::string_view name = "1-F0";
  template <class T>
  static T factor(const T&, const T&, const T& f0) {
    return integer<T>(1) - f0;
  }
};

/// 1: the surface is left out of the account.
struct Unattenuated {
  static constexpr std::string_view name = "1";
  template <class T>
  static T factor(const T&, const T&, const T&) {
    return integer<T>(1);
  }
};

/// How the codes of a chart may have been read. The chart says sRGB; the first of the others is its usual
/// stand-in, the second that with the slip of dividing an 8-bit code by 256.
inline constexpr std::string_view chart_convention = "sRGB";
inline constexpr std::string_view other_chart_conventions = "gamma 2.2, gamma 2.2 of code/256";

/// The rows of the ledger on this topic.
inline constexpr std::array material_claims{
    Claim{.id = "chart-dielectric",
          .statement = "the chart's sRGB codes 40 to 75, for dielectrics, are 0.017 to 0.067 in linear light",
          .printed = {{"from", "0.017"}, {"to", "0.067"}},
          .inputs = {{"from code", "40"},
                     {"to code", "75"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation =
              "The chart's texture is sRGB-encoded and a GPU decodes it so (IEC 61966-2-1). Each code "
              "is decoded by that function, and by a plain power, which is off most in the dark. The "
              "exponents for which a power of code/255 rounds to both printed numbers follow from "
              "log(printed -+ half a digit)/log(code/255). Code/256 is the common slip of dividing "
              "by the number of codes.",
          .source = sources::lagarde_2012_chart},
    Claim{.id = "chart-metal",
          .statement = "the chart's sRGB codes 155 to 255, for metals, are 0.33 to 1.0 in linear light",
          .printed = {{"from", "0.33"}, {"to", "1.0"}},
          .inputs = {{"from code", "155"},
                     {"to code", "255"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation = "Decoded as for chart-dielectric. In the bright the functions come so close together "
                        "that two digits do not tell them apart.",
          .source = sources::lagarde_2012_chart},
    Claim{.id = "chart-range-typo",
          .statement = "the linear range of the specular of dielectrics, given twice, ends at one number: at "
                       "0.067 where materials are explained, at 0.063 where it is remapped to [0, 1]",
          .printed = {{"first", "0.067"}, {"second", "0.063"}},
          .inputs = {{"code", "75"},
                     {"convention", chart_convention},
                     {"other conventions", other_chart_conventions}},
          .derivation = "The second number is judged by the first: both speak of the upper end of the same "
                        "chart, code 75. Which of them is meant, that code says; and each says which code it "
                        "would be.",
          .source = sources::pestana_workflows_2014},
    Claim{
        .id = "chart-overlap",
        .statement = "the chart's ranges hold those of common materials: dielectrics of 0.02 to 0.05 within "
                     "codes 40 to 75, metals of 0.5 to 1 within codes 155 to 255",
        .inputs = {{"dielectric codes", "40, 75"},
                   {"common dielectrics", "0.02, 0.05"},
                   {"metal codes", "155, 255"},
                   {"common metals", "0.5, 1"},
                   {"convention", chart_convention},
                   {"other conventions", other_chart_conventions}},
        .derivation = "An interval of linear reflectance lies within another or sticks out; the chart's are "
                      "its codes decoded. The chart speaks of overlap; read as holding, since a range that "
                      "artists are kept within has to hold what they need. Whether they overlap stands "
                      "beside.",
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
              "Middle grey is read as half of the light, which is what code 187 is near to. The grey "
              "card of photography, 18 % of the light, is another grey; its code stands beside.",
          .source = sources::lagarde_2011_feeding},
    Claim{.id = "metallic-workflow",
          .statement =
              "the metallic workflow's albedo (1-m) c and specular F0 = lerp(0.03, c, m), for a base "
              "colour c and metallic m, reflect no more than comes in: albedo + F0 <= 1",
          .printed = {{"F0 of dielectrics", "0.03"}},
          .inputs = {{"codes", "256"}},
          .derivation = "(1-m) c + 0.03 (1-m) + c m = c + 0.03 (1-m): linear in both, so the region is a "
                        "triangle cut off the corner c = 1, m = 0. Counted besides over every pair of 8-bit "
                        "codes, the colour sRGB-encoded and metallic linear, by the sum itself.",
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
          .statement = "a Lambertian term times (1-F_i)(1-F_o), or times its cheaper stand-in 1-F0, keeps "
                       "specular + diffuse <= 1 at every angle (F_i, F_o: Fresnel towards light and view)",
          .inputs = {{"factor", TransmittedBothWays::name},
                     {"stand-in", TransmittedAtNormal::name},
                     {"beside", TransmittedIn::name},
                     {"albedo", "1"},
                     {"f0", "0.04"}},
          .derivation =
              "Light from one direction: F_i of it is mirrored, and the diffuse term sends out albedo "
              "times the mean of the factor over the hemisphere of views, weighted by the cosine. F "
              "is Schlick's. (1-F_i)(1-F_o) has the mean (1-F_i)(1-f0) 20/21, so the sum stays below "
              "1 for every f0 up to grazing light, where F_i = 1. With 1-F0 and albedo a the sum "
              "f0 + (1-f0) w + a (1-f0), w = (1-c)^5, is at most 1 where w <= 1-a. Every factor is "
              "linear in F_i, so the extremes lie at normal and at grazing light. Light and view "
              "exchanged (light from everywhere, seen from one direction) is judged as well.",
          .source = sources::lagarde_2011_adopting},
};

}  // namespace shadefit
