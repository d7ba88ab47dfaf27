#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Environment maps: solid angles of caps, lobes and texels, and which mip level serves which specular power.
namespace shadefit {

/// The level whose mean texel covers what the lobe of power s covers: log2(w sqrt(3)) - 1/2 log2(s + 1).
/// Source: McGuire et al. 2013, "Plausible Environment Lighting in Two Lines of Code".
template <class T>
T mip_level_of_power(const T& width, const T& exponent) {
  const T half = integer<T>(1) / integer<T>(2);
  return log2(width * sqrt(integer<T>(3))) - half * log2(exponent + integer<T>(1));
}

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> environment_map_claims{};

}  // namespace shadefit
