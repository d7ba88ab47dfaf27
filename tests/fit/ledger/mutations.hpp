#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fit/ledger/ledger.hpp"

namespace shadefit {

/// One claim, with its own fits.
inline Finding evaluate(const Claim& claim) {
  Fits fits;
  return evaluate(claim, fits);
}

/// A copy of the claim with its i-th printed number changed.
inline Claim with_printed(Claim claim, std::size_t i, std::string_view value) {
  claim.printed[i].value = value;
  return claim;
}

/// A copy of the claim with an input changed.
inline Claim with_input(Claim claim, std::string_view name, std::string_view value) {
  for (Quantity& input : claim.inputs) {
    if (input.name == name) {
      input.value = value;
      return claim;
    }
  }
  throw std::out_of_range("no input of that name");
}

/// A formula of the definitions of a claim that is data.
inline double computed_number(Claim claim, std::string_view formula) {
  const std::string text = "{" + std::string(formula) + ":.17g}";
  claim.computed = text;
  claim.evidence = "";
  return std::stod(evaluate(claim).computed);
}

inline std::string name_of(const std::optional<Verdict>& verdict) {
  return std::string(verdict ? name(*verdict) : "undecided");
}

inline std::string verdict_of(const Claim& claim) {
  return name_of(evaluate(claim).verdict);
}

}  // namespace shadefit
