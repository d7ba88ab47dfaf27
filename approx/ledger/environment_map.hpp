#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Environment maps.
namespace shadefit {

inline constexpr std::array environment_map_claims{
    Claim{.id = "cap-solid-angle",
          .statement = "a cap of half-angle `phi` covers `2 pi (1 - cos(phi))` steradians",
          .inputs = {{"half-angles in degrees", "1,10,30,60,90,120,180"}, {"tolerance", "1e-10"}},
          .derivation =
              "The integral of 2 pi sin(theta) from 0 to phi. It is integrated by two rules. The tolerance "
              "is relative: at one degree 1 - cos(phi) = 1.5e-4 loses four of the sixteen digits of a "
              "double. 4 pi sin^2(phi/2) is the same and loses no digits.",
          .source = sources::mcguire_2013},
    Claim{.id = "lobe-solid-angle",
          .statement =
              "`2 pi` times the integral of `cos^s(theta) sin(theta)` over the hemisphere is `2 pi/(s + 1)`",
          .inputs = {{"powers", "0.1,1,2,8,32,128,512,2048,16000,100000"}, {"tolerance", "1e-12"}},
          .derivation =
              "With c = cos(theta) it is 2 pi times the integral of c^s dc over [0, 1]. It is integrated by "
              "two rules in two variables, Gauss-Kronrod over the cosine and tanh-sinh over the angle.",
          .source = sources::mcguire_2013},
    Claim{.id = "texel-solid-angle",
          .statement =
              "a texel of level `m` of a cube map of width `w` covers `4 pi/(6 (w 2^-m)^2)` steradians on "
              "average, less in a face's corners, more at its centre",
          .inputs = {{"width", "128"}, {"level", "0"}, {"tolerance", "1e-10"}},
          .derivation =
              "A face is the square [-1, 1]^2 at distance 1. A small area on it covers (1 + x^2 + "
              "y^2)^(-3/2) of its size in steradians. The integral of that from the centre to (x, y) is "
              "atan(x y/sqrt(1 + x^2 + y^2)), so a face covers 4 atan(1/sqrt(3)) = 2 pi/3, a sixth of the "
              "sphere. A small texel of size 2/w covers (2/w)^2 times the density at its place: 1 at the "
              "centre, 3^(-3/2) in a corner. Over the mean, 4 pi/(6 w^2), that is 6/pi and 6/(pi 3^(3/2)). "
              "The closed form and a product of two Gauss-Kronrod rules have to agree.",
          .source = sources::mcguire_2013},
    Claim{.id = "mip-level",
          .statement = "the level whose mean texel covers as much as the lobe of power `s` is "
                       "`m = log2(w sqrt(3)) - 0.5 log2(s + 1)`",
          .printed = {{"under the root", "3"}, {"factor of the second logarithm", "0.5"}},
          .inputs = {{"widths", "16,128,1024"}, {"powers", "2,32,2048,16000"}, {"tolerance", "1e-10"}},
          .derivation =
              "2 pi/(s + 1) = 4 pi/(6 (w 2^-m)^2) gives 4^m = 3 w^2/(s + 1). The equation is solved for m by "
              "bisection, without a logarithm, and both constants are taken from the roots: 4^m (s + 1)/w^2 "
              "and the slope over log2(s + 1). Level 0 belongs to s = 3 w^2 - 1, the last level to s = 2.",
          .source = sources::mcguire_2013},
    Claim{.id = "mip-lambert",
          .statement =
              "the lowest mip level, one texel a face, approximates a lobe of the cosine to the first power",
          .printed = {{"power", "1"}},
          .inputs = {{"widths", "16,128,1024"}, {"tolerance", "1e-12"}},
          .derivation =
              "The last level is m = log2(w), where a texel is a face of 4 pi/6 steradians. The lobe that "
              "covers as much has s + 1 = 3 at every width. The cosine itself covers pi. A face is a square "
              "with hard edges, which is a further difference and not counted.",
          .source = sources::mcguire_2013},
    Claim{.id = "mip-mean-power",
          .statement =
              "a cube map with faces 128 texels wide, filtered with a cosine lobe, looks unblurred in a "
              "reflection "
              "only for powers above 16000",
          .printed = {{"power", "16000"}},
          .inputs = {{"width", "128"}, {"significant digits", "2"}, {"falls by e to the minus", "1,2"}},
          .derivation =
              "The source names no criterion. The first one tried: the lobe covers one mean texel of level "
              "0, s = 3 w^2 - 1. The next ones: it covers one texel at the centre of a face, or one in a "
              "corner; or it has fallen to e^-1 or e^-2 at the centre of the next texel in the middle of a "
              "face. There tan(theta) = 2/w, so s = 2 n/log(1 + 4/w^2) for e^-n. The printed number is read "
              "to its significant digits. Where a criterion other than the first gives these digits, the "
              "verdict is other-objective.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = "mip-gloss-chain",
          .statement =
              "a chain of levels from 128 down to 4 texels, of which level `m` is made for the power "
              "`round(2^(10 g + 1))` with `g = 1 - m/(levels - 1)`",
          .printed = {{"", "2048"}, {"", "512"}, {"", "128"}, {"", "32"}, {"", "8"}, {"", "2"}},
          .inputs = {{"width", "128"}, {"last width", "4"}, {"octaves", "10"}, {"first octave", "1"}},
          .derivation =
              "Read as a formula, each of the five steps takes two octaves. The printed loop divides the "
              "integer level by the integer levels - 1 before it subtracts from 1.0. In C and C++ this "
              "quotient is 0 up to the last level, where it is 1. (The type of the count is not shown. If it "
              "were a float, the loop would be the formula.) The series is the intended result of the "
              "formula: in 2012 its author prints it for a filter that scales the power by a quarter per "
              "level.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = "mip-sphere-powers",
          .statement = "eleven spheres of gloss 1, 0.9 .. 0 have the powers `2^(10 g + 1)`",
          .printed = {{"", "2048"},
                      {"", "1024"},
                      {"", "512"},
                      {"", "256"},
                      {"", "128"},
                      {"", "64"},
                      {"", "32"},
                      {"", "16"},
                      {"", "8"},
                      {"", "4"},
                      {"", "2"}},
          .inputs = {{"spheres", "11"}, {"octaves", "10"}, {"first octave", "1"}},
          .derivation = "Eleven glosses have ten steps between them, of one octave each.",
          .source = sources::lagarde_2011_adopting},
    Claim{
        .id = "mip-power-drop",
        .statement = "a first power of 2048 that drops to 0.25 of itself per level gives the printed series",
        .printed = {{"", "2048"}, {"", "512"}, {"", "128"}, {"", "32"}, {"", "8"}, {"", "2"}},
        .inputs = {{"first power", "2048"}, {"drop", "0.25"}, {"octaves", "10"}},
        .derivation =
            "s drop^m. The chain of a gloss that spans so many octaves over its levels drops by "
            "2^(-octaves/(levels - 1)) per level. For the printed number of levels this is the same chain; "
            "for another number it is not.",
        .source = sources::lagarde_2012_cubemapgen},
    Claim{.id = "mip-select",
          .statement =
              "a shader reads the level with the number (`1 - g`) times the count of levels, from a chain "
              "whose level `m` is made for `g = 1 - m/(levels - 1)`: it finds the power of its gloss",
          .inputs = {{"levels", "6"},
                     {"octaves", "10"},
                     {"first octave", "1"},
                     {"gloss bits", "8"},
                     {"gloss steps that count as found", "1"}},
          .derivation =
              "The level belongs to the gloss g' = 1 - (1 - g) levels/(levels - 1), so the power found is "
              "2^(-octaves (1 - g)/(levels - 1)) of the power wanted, down to g = 1/levels, where it is "
              "2^(-octaves/levels); below, the level is clamped to the last one. Between two levels the "
              "chain is assumed to hold the power of the formula; trilinear filtering mixes two lobes there, "
              "which is not exactly one lobe. A power within one step of the stored gloss counts as found. A "
              "shader that finds it only at the two ends of the gloss, where any count reads the first and "
              "the last level, would be `refuted`. With levels - 1 as its count, the shader inverts the "
              "generator.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = "power-range",
          .statement =
              "specular powers of real surfaces run from 0.1 to more than 100000, too much for the 8 bits "
              "of a texture; we derive the step of an 8-bit gloss over `[2, 2048]`",
          .printed = {{"step in % (derived)", "2.76"}},
          .inputs = {{"least", "0.1"},
                     {"most", "100000"},
                     {"octaves", "10"},
                     {"first octave", "1"},
                     {"bits", "8"},
                     {"more bits", "16"}},
          .derivation =
              "A gloss that spans so many octaves in 2^bits - 1 steps changes the power by 2^(octaves/steps) "
              "- 1 of itself per step, the same everywhere. A power stored as a whole number changes by 1, "
              "which is 100 % at power 1. The range itself is taken as given: the source cites it as "
              "measured (Ngan, Durand, Matusik 2005, Experimental Analysis of BRDF Models). The lobe c^s "
              "moves by at most step/e, the largest value of x exp(-x) times the step.",
          .source = sources::lagarde_2011_adopting},
};

}  // namespace shadefit
