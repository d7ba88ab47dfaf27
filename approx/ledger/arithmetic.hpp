#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: What half, float and double make of a lobe.
namespace shadefit {

inline constexpr std::array arithmetic_claims{
    Claim{.id = "sg-nonzero-at-zero",
          .statement = "the exponential never reaches zero and the power does: `exp(1000*0 - 1000) != 0`, "
                       "`pow(0, 1000) == 0`",
          .inputs = {{"power", "1000"}, {"formats", "half, float, double"}},
          .derivation =
              "exp(-k) is never exactly 0. In a format whose least positive number is 2^-m it rounds to 0 "
              "below half of that, from k = (m+1) ln 2 on. Where subnormals are flushed it becomes 0 below "
              "the least normal number 2^-n, from about k = n ln 2 on. Both places are searched for in the "
              "format itself.",
          .source = sources::lagarde_2012},
    Claim{.id = "pow-nan-at-zero",
          .statement =
              "`c^b` as `exp2(log2(c) b)` gives NaN at `c = 0`; the spherical Gaussian `exp2(A c - A)`, "
              "`A = k/ln 2`, never does",
          .inputs = {{"exponents", "0, 0.5, 1, 1000"},
                     {"formats", "half, float, double"},
                     {"powers up to", "100000"}},
          .derivation =
              "log2(0) = -infinity. Times b > 0 it stays -infinity, and exp2 gives 0, the right value. Times "
              "b = 0 it is NaN, although c^0 is 1. A c - A is finite as long as A is. Where k/ln 2 overflows "
              "the format, A c - A is infinity - infinity, or 0 times infinity at c = 0. Real powers run "
              "from 0.1 to more than 100000: the input `powers up to`.",
          .source = sources::lagarde_2012},
    Claim{.id = "half-banding",
          .statement =
              "at power 1024 a highlight bands in half precision, by pow and by the spherical Gaussian "
              "alike; low powers show nothing",
          .printed = {{"power", "1024"}},
          .inputs = {{"low power", "8"},
                     {"visible step in 8-bit sRGB codes", "1"},
                     {"samples of a float cosine", "2048"},
                     {"powers up to", "2048"}},
          .derivation =
              "A highlight of peak 1 bands where two neighbouring samples differ by more than one 8-bit sRGB "
              "code beyond what the exact curve does between them. With the cosine in half, the samples are "
              "the halves in [0.5, 1]; each stands for all cosines that round to it. Their spacing, 2^-11, "
              "alone makes steps of k/2048 of the value. With the cosine in float and arithmetic in half, "
              "each operation rounds its result to half. A c is near A, where halves are A/1024 to A/2048 "
              "apart. log2(c) and c - 1 are small near the peak and keep their digits.",
          .source = sources::lagarde_2012},
};

}  // namespace shadefit
