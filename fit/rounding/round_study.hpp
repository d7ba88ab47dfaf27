#pragma once

#include <vector>

#include "fit/rounding/rounded_set.hpp"

/// The best constants of a study in a number format, and good ones for evaluating it in the format.
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

/// Constants of a study in half or float with a small largest error when the form is evaluated in that
/// format, its constants and operations rounded to nearest in the order of the formula. From the rounded fit,
/// the rounded minimax fit and `published`, if there is one, `moved_constants` looks for better ones; of a
/// form with any number of parameters. In float they are judged at a sample of the range while searching. The
/// errors of the result are over every number of the format. Nothing is proven about other constants. Throws
/// UserError for other formats, measured rows, several variables, constraints, an integral in the form, in
/// float also in the target, and if a constant overflows the format.
RoundedStudy evaluate_study(const StudyObjective& objective, const StudyFit& fit, const NumberFormat& format,
                            const std::vector<double>& published = {},
                            const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
