#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Other kernels for a lobe: Gauss-Weierstrass and Abel-Poisson, as printed and on the sphere.
namespace shadefit {

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> kernels_claims{};

}  // namespace shadefit
