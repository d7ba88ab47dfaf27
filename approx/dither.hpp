#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Dithering and marching through volumes.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> dither_claims{};

}  // namespace shadefit
