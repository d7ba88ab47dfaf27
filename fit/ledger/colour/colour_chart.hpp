#pragma once

#include "fit/ledger/finding.hpp"

/// Codes of a colour chart and the linear values that are printed for them. Every record has a "convention"
/// for decoding codes, and "other conventions"
/// (fit/ledger/colour/transfer_function.hpp).
namespace shadefit {

/// Two printed linear values against the codes "from code" and "to code".
Finding chart_range(const Claim& claim);

/// Two printed linear values that should both be the decoded "code".
Finding chart_range_given_twice(const Claim& claim);

/// Whether the ranges of common dielectrics and of common metals are within the range of the chart's codes.
Finding chart_holds_common_materials(const Claim& claim);

/// A printed code against the encoding of "linear".
Finding middle_grey(const Claim& claim);

}  // namespace shadefit
