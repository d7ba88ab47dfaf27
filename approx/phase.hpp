#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Phase functions of volumes: Henyey-Greenstein.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> phase_claims{};

}  // namespace shadefit
