#pragma once

#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/rounding/round_study.hpp"

namespace shadefit {

/// The best constants of a format for a fit of a family, over its domain: those of its study in plain
/// formulas of c (`round_study`). The error is absolute or relative as in the fit's metric; its norm does not
/// matter. Given parameters are only rounded. `published` are the parameters' published values, or empty.
/// Throws UserError like `round_study`, and if the exponent is not a number of the format.
RoundedStudy round_fit(const Fit& fit, const NumberFormat& format, const std::vector<double>& published,
                       const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
