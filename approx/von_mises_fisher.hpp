#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// The von Mises-Fisher density: a spherical Gaussian that integrates to 1 over the sphere.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> von_mises_fisher_claims{};

}  // namespace shadefit
