#pragma once

#include "fit/ledger/finding.hpp"

/// The claim about bands of a highlight in half precision.
namespace shadefit {

/// Judges the claim that in half a highlight of the printed power bands and one of the low power does not, by
/// pow
/// and by the spherical Gaussian, with the cosine in half and in float.
Finding evaluate_half_banding(const Claim& claim);

}  // namespace shadefit
