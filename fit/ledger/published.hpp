#pragma once

#include <initializer_list>
#include <string_view>

#include "fit/ledger/finding.hpp"

/// Claims about the constants of fitted families.
namespace shadefit {

/// Judges the printed numbers of a claim as those of the published records of these ids, one each, in their
/// order: by fits on the domain of the inputs `from`, `to`, over the exponents of the input `exponents` where
/// the claim has one.
Finding evaluate_published(const Claim& claim, std::initializer_list<std::string_view> published_ids);

}  // namespace shadefit
