#pragma once

#include "approx/records/claim.hpp"
#include "fit/ledger/finding.hpp"

/// The claims on solid angles of caps, lobes and texels, and the mip level that follows from them.
namespace shadefit {

Finding evaluate_cap(const Claim& claim);
Finding evaluate_lobe(const Claim& claim);
Finding evaluate_texel(const Claim& claim);
Finding evaluate_mip_level(const Claim& claim);

}  // namespace shadefit
