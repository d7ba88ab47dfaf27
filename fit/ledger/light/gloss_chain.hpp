#pragma once

#include "approx/records/claim.hpp"
#include "fit/ledger/finding.hpp"

/// The claims on prefiltered chains: the powers for which their levels are made, and the level that is read.
namespace shadefit {

Finding evaluate_gloss_chain(const Claim& claim);
Finding evaluate_sphere_powers(const Claim& claim);
Finding evaluate_power_drop(const Claim& claim);
Finding evaluate_mip_select(const Claim& claim);

}  // namespace shadefit
