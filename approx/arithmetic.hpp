#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// What half, float and double make of a lobe: claims about zero, NaN and banding.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> arithmetic_claims{};

}  // namespace shadefit
