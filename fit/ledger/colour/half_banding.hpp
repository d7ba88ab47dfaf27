#pragma once

#include "fit/ledger/finding.hpp"

/// The claim about bands of a highlight in half precision.
namespace shadefit {

/// Judges whether a highlight of the printed power bands in half and one of the low power does not, by pow
/// and by the spherical Gaussian, with the cosine in half and in float.
Finding evaluate_half_banding(const Claim& claim);

}  // namespace shadefit
