#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/rounding/round_family.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/refit.hpp"

/// What `fit` adds to the constants on request: rounded constants.
namespace shadefit {

/// The rounded constants of a fit, or why there are none: the fit did not converge, or the format cannot hold
/// it.
struct RoundedFit {
  std::optional<RoundedStudy> rounded = std::nullopt;
  std::string reason = {};
};

/// Rounds every fit, and the published values if each parameter has one; `next` is called before each fit.
/// `is_record`: the exponents are the record's own, and an exponent that the format cannot hold is left out.
/// Throws UserError if the format cannot hold an exponent that the user chose.
std::vector<RoundedFit> round_fits(const Refit& refit, const NumberFormat& format, bool is_record,
                                   const Checkpoint& next, const Checkpoint& checkpoint);

}  // namespace shadefit
