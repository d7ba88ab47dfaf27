#pragma once

#include <string>
#include <vector>

#include "fit/ledger/ledger.hpp"

/// What a reader does not know yet: the claims that do not hold, or only in part.
namespace shadefit {

/// The refuted and the conditional claims: what was stated, what was found, and what that does to a picture.
std::string news_section(const std::vector<JudgedClaim>& claims);

/// The claims with a verdict, in the order of the ledger.
std::vector<JudgedClaim> claims_with(const std::vector<JudgedClaim>& claims, Verdict verdict);

}  // namespace shadefit
