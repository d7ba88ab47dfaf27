#pragma once

#include "fit/ledger/finding.hpp"
#include "fit/verdicts/refit.hpp"

/// Claims about the constants of fitted families.
namespace shadefit {

/// Judges the printed numbers of a claim like its published constants: by fits on the domain of the inputs
/// `from` and `to`, over the input `exponents` if the claim has one.
Finding evaluate_published(const Claim& claim, Fits& fits);

}  // namespace shadefit
