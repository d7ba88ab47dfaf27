#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "approx/records/claim.hpp"
#include "fit/ledger/ledger.hpp"

/// Nothing in a finding is typed: the printed numbers and the inputs decide it.
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

inline std::string verdict_of(const Claim& claim) {
  const auto verdict = evaluate(claim).verdict;
  return std::string(verdict ? name(*verdict) : "undecided");
}

/// One number of a claim changed: the printed one of that place, or the input of that name.
struct Mutation {
  std::string_view claim;
  std::string_view what;  ///< an input's name, or "printed 0", "printed 1", ..
  std::string_view value;
};

/// Every printed number and every input of every claim has a mutation; a changed printed number changes the
/// verdict, a changed input the evidence (or what is computed). A claim without printed numbers has at least
/// one input.
inline void check_mutations(std::span<const Claim> claims, const std::vector<Mutation>& mutations) {
  const auto mutations_of = [&](std::string_view claim, const std::string& what) {
    std::vector<Mutation> found;
    for (const Mutation& m : mutations) {
      if (m.claim == claim && m.what == what) found.push_back(m);
    }
    return found;
  };
  std::size_t used = 0;
  for (const Claim& claim : claims) {
    EXPECT_FALSE(claim.printed.empty() && claim.inputs.empty())
        << claim.id << " rests on nothing that can be changed";
    const Finding before = evaluate(claim);
    for (std::size_t i = 0; i < claim.printed.size(); ++i) {
      const auto found = mutations_of(claim.id, "printed " + std::to_string(i));
      EXPECT_FALSE(found.empty()) << claim.id << ": no mutation of printed " << i;
      for (const Mutation& m : found) {
        const Finding after = evaluate(with_printed(claim, i, m.value));
        EXPECT_TRUE(before.verdict != after.verdict)
            << claim.id << ": " << claim.printed[i].value << " -> " << m.value << " keeps the verdict "
            << (after.verdict ? name(*after.verdict) : "undecided") << ": " << after.evidence;
      }
      used += found.size();
    }
    for (const Quantity& input : claim.inputs) {
      const auto found = mutations_of(claim.id, std::string(input.name));
      EXPECT_FALSE(found.empty()) << claim.id << ": no mutation of the input " << input.name;
      for (const Mutation& m : found) {
        const Finding after = evaluate(with_input(claim, input.name, m.value));
        EXPECT_TRUE(before.evidence != after.evidence || before.computed != after.computed)
            << claim.id << ": " << input.name << " = " << input.value << " -> " << m.value
            << " leaves the evidence as it was: " << after.evidence;
      }
      used += found.size();
    }
  }
  EXPECT_EQ(used, mutations.size()) << "a mutation names no claim of these, or nothing of its claim";
}

/// Each digit of each printed decimal number of a confirmed claim, changed by five, takes the confirmation
/// away.
inline void check_every_digit(const Claim& claim) {
  ASSERT_EQ(verdict_of(claim), "confirmed") << claim.id;
  for (std::size_t i = 0; i < claim.printed.size(); ++i) {
    const std::string printed(claim.printed[i].value);
    for (std::size_t place = 0; place < printed.size(); ++place) {
      if (printed[place] < '0' || printed[place] > '9') continue;
      std::string changed = printed;
      changed[place] = static_cast<char>('0' + (printed[place] - '0' + 5) % 10);
      EXPECT_NE(verdict_of(with_printed(claim, i, changed)), "confirmed") << claim.id << ": " << changed;
    }
  }
}

}  // namespace shadefit
