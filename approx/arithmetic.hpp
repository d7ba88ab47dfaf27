#pragma once

#include <array>

#include "approx/gloss.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// What half, float and double make of a lobe: claims about zero, NaN and banding. A = k/ln 2 is the power
/// for exp2 of `base_two_power`.
namespace shadefit {

/// The exponent of `power_by_exp2`, k log2(c).
template <class T>
T power_exponent_base_two(const T& cos_theta, const T& exponent) {
  return log2(cos_theta) * exponent;
}

/// c^k as a GPU computes it: exp2(k log2(c)). c in [0, 1]; c = 0 gives exp2(-infinity) = 0 for k > 0 and
/// exp2(-infinity * 0) = NaN for k = 0.
template <class T>
T power_by_exp2(const T& cos_theta, const T& exponent) {
  return exp2(power_exponent_base_two(cos_theta, exponent));
}

/// The spherical Gaussian of `gaussian_lobe_base_two` with the subtraction first, exp2(A (c - 1)): c - 1 is
/// exact for c in [0.5, 1], whatever format c is in, so that what rounding is left is relative to the
/// exponent and not to A.
template <class T>
T gaussian_lobe_base_two_of_difference(const T& cos_theta, const T& base_two) {
  return exp2(base_two * (cos_theta - integer<T>(1)));
}

/// The rows of the ledger on this topic.
inline constexpr std::array arithmetic_claims{
    Claim{.id = "sg-nonzero-at-zero",
          .statement = "the exponential never reaches zero and the power does: exp(1000*0 - 1000) != 0, "
                       "pow(0, 1000) == 0",
          .inputs = {{"power", "1000"}, {"formats", "half, float, double"}},
          .derivation =
              "exp(-k) is not 0 exactly. In a format whose least positive number is 2^-m it rounds to 0 once "
              "it "
              "falls below half of that, at k = (m+1) ln 2; where subnormals are flushed once it rounds to "
              "less than the least normal number 2^-n, at about k = n ln 2. Both places are searched for in "
              "the format itself.",
          .source = sources::lagarde_2012},
    Claim{
        .id = "pow-nan-at-zero",
        .statement = "c^b as exp2(log2(c) b) gives NaN at c = 0; the spherical Gaussian exp2(A c - A), "
                     "A = k/ln 2, never does",
        .inputs = {{"exponents", "0, 0.5, 1, 1000"},
                   {"formats", "half, float, double"},
                   {"powers up to", "100000"}},
        .derivation =
            "log2(0) = -infinity. Times b > 0 it stays so and exp2 gives 0, the right value; times b = 0 it "
            "is NaN, where c^0 is 1. A c - A is a number as long as A is; where k/ln 2 overflows the format, "
            "A c - A is infinity - infinity, or 0 times infinity at c = 0. Real powers run from 0.1 to more "
            "than 100000: the input `powers up to`.",
        .source = sources::lagarde_2012},
    Claim{
        .id = "half-banding",
        .statement = "at power 1024 a highlight bands in half precision, by pow and by the spherical "
                     "Gaussian alike; low powers show nothing",
        .printed = {{"power", "1024"}},
        .inputs = {{"low power", "8"},
                   {"visible step in 8-bit sRGB codes", "1"},
                   {"samples of a float cosine", "2048"},
                   {"powers up to", "2048"}},
        .derivation =
            "A highlight of peak 1 bands where two neighbouring samples differ by more than one 8-bit sRGB "
            "code beyond what the exact curve does between them. With the cosine in half, a sample is one of "
            "the halves in [0.5, 1], each standing for all cosines that round to it: their spacing 2^-11 "
            "alone is a step of k/2048 of the value. With the cosine in float and half arithmetic, each "
            "operation rounds its result to half: A c is near A, where halves are A/1024 to A/2048 apart; "
            "log2(c) and c - 1 are small near the peak and keep their digits.",
        .source = sources::lagarde_2012},
};

}  // namespace shadefit
