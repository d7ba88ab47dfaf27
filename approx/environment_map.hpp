#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Environment maps: solid angles of caps, lobes and texels, and which mip level serves which specular power.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> environment_map_claims{};

}  // namespace shadefit
