#pragma once

#include "fit/ledger/finding.hpp"

/// Codes of a colour chart against the linear values that are printed beside them. Every record gives a
/// "convention" by which codes are decoded, and "other conventions"
/// (fit/ledger/colour/transfer_function.hpp).
namespace shadefit {

/// Two printed linear values against the codes "from code" and "to code".
Finding chart_range(const Claim& claim);

/// Two printed linear values that should be one, the decoded "code".
Finding chart_range_given_twice(const Claim& claim);

/// Whether the range of common dielectrics, and of common metals, lies within that of the chart's codes.
Finding chart_holds_common_materials(const Claim& claim);

/// A printed code against the encoding of "linear".
Finding middle_grey(const Claim& claim);

}  // namespace shadefit
