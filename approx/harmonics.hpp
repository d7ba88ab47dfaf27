#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Spherical harmonics of low order, and what storing them costs.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> harmonics_claims{};

}  // namespace shadefit
