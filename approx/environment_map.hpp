#pragma once

#include <array>

#include "approx/gloss.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Environment maps: solid angles of caps, lobes and texels, and which mip level serves which specular power.
/// Solid angles are in steradians; s > 0 is a specular power, w the texels along an edge of a cube face at
/// level 0, m a mip level (0 the finest; it need not be whole), g a gloss in [0, 1].
namespace shadefit {

/// The cap of directions within the angle phi of an axis, phi in [0, pi] radians: 2 pi (1 - cos(phi)).
template <class T>
T cap_solid_angle(const T& half_angle) {
  return integer<T>(2) * pi<T>() * (integer<T>(1) - cos(half_angle));
}

/// The same without the cancellation of narrow caps: 1 - cos(phi) = 2 sin^2(phi/2).
template <class T>
T cap_solid_angle_near_axis(const T& half_angle) {
  const T half_sine = sin(half_angle / integer<T>(2));
  return integer<T>(4) * pi<T>() * (half_sine * half_sine);
}

/// What the lobe cos^s(theta) over the hemisphere covers, each direction counted by the lobe: 2 pi/(s + 1).
template <class T>
T lobe_solid_angle(const T& exponent) {
  return integer<T>(2) * pi<T>() / (exponent + integer<T>(1));
}

/// The power whose lobe covers that solid angle: the inverse of `lobe_solid_angle`.
template <class T>
T power_of_solid_angle(const T& solid_angle) {
  return integer<T>(2) * pi<T>() / solid_angle - integer<T>(1);
}

/// The power whose lobe has fallen to e^-n of its peak where the angle to its axis has that tangent:
/// cos(theta) = 1/sqrt(1 + tan^2(theta)), so s = 2 n / log(1 + tan^2(theta)).
template <class T>
T power_that_falls(const T& folds, const T& tangent) {
  return integer<T>(2) * folds / log1p(tangent * tangent);
}

/// The texels along an edge of a face at level m: w 2^-m.
template <class T>
T texels_along_edge(const T& width, const T& level) {
  return width * exp2(-level);
}

/// The mean solid angle of a texel of level m: the sphere over the texels of six faces, 4 pi/(6 (w 2^-m)^2).
template <class T>
T mean_texel_solid_angle(const T& width, const T& level) {
  const T edge = texels_along_edge(width, level);
  return integer<T>(4) * pi<T>() / (integer<T>(6) * (edge * edge));
}

/// Solid angle per area of a cube face, the square [-1, 1]^2 at distance 1: 1/r^2 times the cosine 1/r at
/// which it is seen, (1 + x^2 + y^2)^(-3/2).
template <class T>
T cube_face_density(const T& x, const T& y) {
  const T r2 = integer<T>(1) + x * x + y * y;
  return integer<T>(1) / (r2 * sqrt(r2));
}

/// The solid angle of the rectangle from the face's centre to (x, y): atan(x y / sqrt(1 + x^2 + y^2)). Its
/// mixed second derivative is `cube_face_density`, and it is 0 on both axes.
template <class T>
T cube_face_solid_angle(const T& x, const T& y) {
  return atan(x * y / sqrt(integer<T>(1) + x * x + y * y));
}

/// The solid angle of the square [x, x + size] x [y, y + size] on a face. Four values of size 1 leave what
/// one texel covers, so the result has lost log10(1/size^2) digits.
template <class T>
T texel_solid_angle(const T& x, const T& y, const T& size) {
  const T right = x + size, top = y + size;
  return cube_face_solid_angle(right, top) - cube_face_solid_angle(x, top) - cube_face_solid_angle(right, y) +
         cube_face_solid_angle(x, y);
}

/// The level whose mean texel covers what the lobe of power s covers: log2(w sqrt(3)) - 1/2 log2(s + 1).
/// Source: McGuire et al. 2013, "Plausible Environment Lighting in Two Lines of Code".
template <class T>
T mip_level_of_power(const T& width, const T& exponent) {
  const T half = integer<T>(1) / integer<T>(2);
  return log2(width * sqrt(integer<T>(3))) - half * log2(exponent + integer<T>(1));
}

/// The relative step of a power between two neighbouring codes of a gloss with that many steps, decoded over
/// so many octaves (doublings, `decode_gloss`): 2^(octaves/steps) - 1.
template <class T>
T relative_gloss_step(const T& octaves, const T& steps) {
  return expm1(ln2<T>() * (octaves / steps));
}

/// The gloss that a generator of a prefiltered chain of so many levels assigns to a level:
/// 1 - m/(levels - 1).
template <class T>
T gloss_of_level(const T& level, const T& levels) {
  return integer<T>(1) - level / (levels - integer<T>(1));
}

/// The level that a shader reads for a gloss, clamped to the last one: min((1 - g) count, last).
template <class T>
T level_of_gloss(const T& gloss, const T& count, const T& last_level) {
  return min((integer<T>(1) - gloss) * count, last_level);
}

/// The power after some levels, each of which scales it by `drop`: s drop^m.
template <class T>
T power_after_drops(const T& power_of_first, const T& drop, int level) {
  return power_of_first * power(drop, level);
}

/// The rows of the ledger on this topic.
inline constexpr std::array environment_map_claims{
    Claim{
        .id = "cap-solid-angle",
        .statement = "a cap of half-angle phi covers 2 pi (1 - cos(phi)) steradians",
        .inputs = {{"half-angles in degrees", "1,10,30,60,90,120,180"}, {"tolerance", "1e-10"}},
        .derivation =
            "The integral of 2 pi sin(theta) from 0 to phi. It is integrated by two rules. The tolerance is "
            "relative: at one degree 1 - cos(phi) = 1.5e-4 has lost four of the sixteen digits of a "
            "double. 4 pi sin^2(phi/2) is the same and loses none.",
        .source = sources::mcguire_2013},
    Claim{.id = "lobe-solid-angle",
          .statement = "2 pi times the integral of cos^s(theta) sin(theta) over the hemisphere is "
                       "2 pi/(s + 1)",
          .inputs = {{"powers", "0.1,1,2,8,32,128,512,2048,16000,100000"}, {"tolerance", "1e-12"}},
          .derivation =
              "With c = cos(theta) it is 2 pi times the integral of c^s dc over [0, 1]. It is integrated by "
              "two rules in two variables, Gauss-Kronrod over the cosine and tanh-sinh over the angle.",
          .source = sources::mcguire_2013},
    Claim{
        .id = "texel-solid-angle",
        .statement =
            "a texel of level m of a cube map of width w covers 4 pi/(6 (w 2^-m)^2) steradians on average, "
            "less in a face's corners, more at its centre",
        .inputs = {{"width", "128"}, {"level", "0"}, {"tolerance", "1e-10"}},
        .derivation =
            "A face is the square [-1, 1]^2 at distance 1, where an area covers (1 + x^2 + y^2)^(-3/2) of "
            "itself. The integral of that from the centre to (x, y) is atan(x y/sqrt(1 + x^2 + y^2)), so a "
            "face covers 4 atan(1/sqrt(3)) = 2 pi/3, a sixth of the sphere. A small texel of size 2/w covers "
            "(2/w)^2 times the density at its place: 1 at the centre, 3^(-3/2) in a corner. Over the mean, "
            "4 pi/(6 w^2), that is 6/pi and 6/(pi 3^(3/2)). The closed form and a product of two "
            "Gauss-Kronrod rules have to agree.",
        .source = sources::mcguire_2013},
    Claim{.id = "mip-level",
          .statement = "the level whose mean texel covers what the lobe of power s covers is "
                       "m = log2(w sqrt(3)) - 0.5 log2(s + 1)",
          .printed = {{"under the root", "3"}, {"factor of the second logarithm", "0.5"}},
          .inputs = {{"widths", "16,128,1024"}, {"powers", "2,32,2048,16000"}, {"tolerance", "1e-10"}},
          .derivation =
              "2 pi/(s + 1) = 4 pi/(6 (w 2^-m)^2) gives 4^m = 3 w^2/(s + 1). The equation is solved for m by "
              "bisection, without a logarithm, and both constants are taken from the roots: "
              "4^m (s + 1)/w^2 and the slope over log2(s + 1). Level 0 belongs to s = 3 w^2 - 1, the last "
              "level to s = 2.",
          .source = sources::mcguire_2013},
    Claim{.id = "mip-lambert",
          .statement = "the lowest mip level, one texel a face, approximates a lobe of the cosine to the "
                       "first power",
          .printed = {{"power", "1"}},
          .inputs = {{"widths", "16,128,1024"}, {"tolerance", "1e-12"}},
          .derivation = "The last level is m = log2(w), where a texel is a face of 4 pi/6 steradians. The "
                        "lobe that covers as much has s + 1 = 3 whatever the width. The cosine itself covers "
                        "pi. That a face is a square with hard edges is a further difference, not counted.",
          .source = sources::mcguire_2013},
    Claim{
        .id = "mip-mean-power",
        .statement = "a cube map of 128 texels a face is reflected unblurred, once it is filtered with a "
                     "cosine lobe, only for powers above 16000",
        .printed = {{"power", "16000"}},
        .inputs = {{"width", "128"}, {"significant digits", "2"}, {"falls by e to the minus", "1,2"}},
        .derivation =
            "The source names no criterion. The first that is tried: the lobe covers one mean texel of level 0, "
            "s = 3 w^2 - 1. After it: one texel at the centre of a face, one in its corner; or the lobe has "
            "fallen by e^-1 or e^-2 at the centre of the next texel, at the middle of a face, where "
            "tan(theta) = 2/w, so s = 2 n/log(1 + 4/w^2) for e^-n. The printed number is read to its "
            "significant digits; where another criterion than the first gives them, the verdict is "
            "other-objective.",
        .source = sources::lagarde_2011_adopting},
    Claim{
        .id = "mip-gloss-chain",
        .statement = "a chain of levels from 128 down to 4 texels, of which level m is made for the power "
                     "round(2^(10 g + 1)) with g = 1 - m/(levels - 1)",
        .printed = {{"", "2048"}, {"", "512"}, {"", "128"}, {"", "32"}, {"", "8"}, {"", "2"}},
        .inputs = {{"width", "128"}, {"last width", "4"}, {"octaves", "10"}, {"first octave", "1"}},
        .derivation =
            "Read as a formula, each of the five steps takes two octaves. The printed loop divides the "
            "level, an integer, by levels - 1, an integer, before it subtracts from 1.0: in C and C++ that "
            "quotient is 0 up to the last level, where it is 1 (the type of the count is not shown; were it "
            "a float, the loop would be the formula). The series is what the formula is meant to give; its "
            "author prints it in 2012 for a filter that scales the power by a quarter per level.",
        .source = sources::lagarde_2011_adopting},
    Claim{.id = "mip-sphere-powers",
          .statement = "eleven spheres of gloss 1, 0.9 .. 0 have the powers 2^(10 g + 1)",
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
    Claim{.id = "mip-power-drop",
          .statement = "a first power of 2048 with a drop of 0.25 per level gives this series",
          .printed = {{"", "2048"}, {"", "512"}, {"", "128"}, {"", "32"}, {"", "8"}, {"", "2"}},
          .inputs = {{"first power", "2048"}, {"drop", "0.25"}, {"octaves", "10"}},
          .derivation =
              "s drop^m. The chain of a gloss that spans so many octaves over its levels drops by "
              "2^(-octaves/(levels - 1)) a level: for the printed number of levels it is the same chain, for "
              "another number it is not.",
          .source = sources::lagarde_2012_cubemapgen},
    Claim{
        .id = "mip-select",
        .statement = "a shader that reads level (1 - g) levels of a chain made for g = 1 - m/(levels - 1) "
                     "finds the power of its gloss",
        .inputs = {{"levels", "6"},
                   {"octaves", "10"},
                   {"first octave", "1"},
                   {"gloss bits", "8"},
                   {"gloss steps that count as found", "1"}},
        .derivation =
            "The level belongs to the gloss g' = 1 - (1 - g) levels/(levels - 1), so the power found is "
            "2^(-octaves (1 - g)/(levels - 1)) of the power wanted, down to g = 1/levels, where it is "
            "2^(-octaves/levels); below, the level is clamped to the last one. Between two levels the "
            "chain is taken to hold the power of the level's formula; trilinear filtering mixes two lobes "
            "there, which is not quite one. Within one step of the stored gloss counts as found; found at the "
            "two ends of the gloss alone, where any count reads the first and the last level, would be "
            "`refuted`. Read with the levels below the first one as its count, the shader inverts the "
            "generator.",
        .source = sources::lagarde_2011_adopting},
    Claim{
        .id = "power-range",
        .statement = "specular powers of real surfaces run from 0.1 to more than 100000, too much for the "
                     "8 bits of a texture; the step of an 8-bit gloss over [2, 2048] follows",
        .printed = {{"step in % (derived)", "2.76"}},
        .inputs = {{"least", "0.1"},
                   {"most", "100000"},
                   {"octaves", "10"},
                   {"first octave", "1"},
                   {"bits", "8"},
                   {"more bits", "16"}},
        .derivation =
            "A gloss that spans so many octaves in 2^bits - 1 steps takes 2^(octaves/steps) - 1 of the power "
            "a step, the same everywhere; a power stored as a whole number steps by 1, which is all of it "
            "at 1. The range itself is taken as given: the source cites it as measured (Ngan, Durand, Matusik "
            "2005, Experimental Analysis of BRDF Models). The lobe c^s moves by at most step/e, the largest "
            "value of x exp(-x) times the step.",
        .source = sources::lagarde_2011_adopting},
};

}  // namespace shadefit
