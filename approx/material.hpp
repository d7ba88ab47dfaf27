#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Materials: colour charts, metals and dielectrics, and the energy that a workflow keeps.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> material_claims{};

}  // namespace shadefit
