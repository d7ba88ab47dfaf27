#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Instruction counts: what a form costs, counted from the formula itself by the symbolic scalar.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> cost_claims{};

}  // namespace shadefit
