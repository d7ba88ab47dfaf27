#pragma once

#include "fit/errors/binary_format.hpp"
#include "fit/scalars/multiprecision.hpp"

/// The ruler: the distance of a computed number from the truth, in units of the last place of its format.
namespace shadefit {

/// The unit of the last place of a format at `truth`: the spacing of the format's numbers in the binade
/// [2^e, 2^(e+1)) that holds |truth|, 2^(e - digits + 1). A power of two belongs to the binade above it: just
/// below 1 the numbers lie half an ulp of 1 apart. Below the normal numbers, and at 0, it is the least
/// subnormal number; beyond the largest number, the spacing in the last binade.
Decimal50 ulp_at(const Decimal50& truth, const BinaryFormat& format);

/// Whether rounding to nearest turns `truth` into an infinity: from half an ulp beyond the largest number on.
bool overflows(const Decimal50& truth, const BinaryFormat& format);

/// |computed - truth| / ulp_at(truth). `computed` is a number of the format, widened; `truth` is no NaN. The
/// sign of a zero does not matter, and a wrong sign needs no special case. Infinite for a NaN, and for an
/// infinity unless the truth rounds to it: then 0. If the truth overflows, a finite number is measured with
/// the ulp of the largest binade.
double ulps_off(double computed, const Decimal50& truth, const BinaryFormat& format);

}  // namespace shadefit
