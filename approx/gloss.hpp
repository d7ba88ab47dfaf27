#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Gloss: how a stored gloss in [0, 1] becomes a specular power, and the identities of logarithms behind it.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> gloss_claims{};

}  // namespace shadefit
