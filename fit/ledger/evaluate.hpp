#pragma once

#include "fit/ledger/finding.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {

/// Computes one claim; fits come from `fits`. Throws std::logic_error for an unknown claim.
Finding evaluate(const Claim& claim, Fits& fits);

}  // namespace shadefit
