#pragma once

#include <vector>

#include "fit/rounding/rounded_set.hpp"

/// The best constants of a study in a number format.
namespace shadefit {

/// Searches a format for the constants with the smallest largest |weight * error| over the ranges: in half
/// and bfloat16 that of the form evaluated in the format, at every number of it; in float and of decimals
/// that of the form in real numbers. Held parameters stay as they are. `published` are values of the
/// parameters, or empty. Throws UserError for measured rows, for constraints, which rounding breaks, for more
/// than six parameters, for an integral in the form, or in float and of decimals in the target, for half or
/// bfloat16 in several variables, and if a constant overflows the format; CheckFailed if no finite error was
/// found or proven.
RoundedStudy round_study(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                         const std::vector<double>& published = {},
                         const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
