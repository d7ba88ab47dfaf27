#pragma once

#include "fit/rounding/rounded_set.hpp"

namespace shadefit {

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
