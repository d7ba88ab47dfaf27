#pragma once

#include <string_view>

#include "fit/ledger/ledger.hpp"

namespace shadefit {

/// The claim of that id, or null.
inline const Claim* find_claim(std::string_view id) {
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      if (claim.id == id) return &claim;
    }
  }
  return nullptr;
}

}  // namespace shadefit
