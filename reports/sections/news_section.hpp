#pragma once

#include <string>
#include <vector>

#include "fit/ledger/ledger.hpp"

/// The news of the report: the claims that do not hold, or only in part.
namespace shadefit {

/// The refuted and the conditional claims: the statement, the evidence, and the effect on a picture.
std::string news_section(const std::vector<JudgedClaim>& claims);

/// The claims with a verdict, in the order of the ledger.
std::vector<JudgedClaim> claims_with(const std::vector<JudgedClaim>& claims, Verdict verdict);

}  // namespace shadefit
