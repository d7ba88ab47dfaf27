#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Microfacet distributions and their shadowing.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> microfacet_claims{};

}  // namespace shadefit
