#pragma once

#include <array>

#include "approx/claim.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

/// Gloss: how a stored gloss in [0, 1] becomes a specular power, and the identities of logarithms behind it.
/// g is the gloss, s = k the specular power, M = s/ln 2 the same power for exp2.
namespace shadefit {

/// The specular power of a gloss: s = 2^(doublings g + first), from 2^first at g = 0 to 2^(doublings + first)
/// at g = 1. Source: Lagarde 2011, "Adopting a physically based shading model" (10 and 1).
template <class T>
T decode_gloss(const T& gloss, const T& doublings, const T& first) {
  return exp2(doublings * gloss + first);
}

/// The rows of the ledger on this topic.
inline constexpr std::array<Claim, 0> gloss_claims{};

}  // namespace shadefit
