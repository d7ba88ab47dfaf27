#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/ledger/finding.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/refit.hpp"

/// All claims, and a finding for each.
namespace shadefit {

/// Every claim, with one section per topic: the files of studies/claims, which the build puts into the
/// library. Read once.
std::span<const Topic> ledger();

/// Whether a claim has this id. It reads no claim: to parse all takes as long as a fit.
bool has_claim(std::string_view id);

struct JudgedClaim {
  const Topic* topic;
  const Claim* claim;
  Finding finding;
};

/// Computes one claim; fits come from `fits`. Throws std::logic_error for an unknown claim.
Finding evaluate(const Claim& claim, Fits& fits);

/// Computes the wanted claims, in the order of the ledger. The checkpoint is called before each.
std::vector<JudgedClaim> judge_claims(const std::function<bool(std::string_view id)>& is_wanted, Fits& fits,
                                      const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
