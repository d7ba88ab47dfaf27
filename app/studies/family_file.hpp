#pragma once

#include "app/options/fit_arguments.hpp"
#include "app/options/options.hpp"
#include "fit/catalogue/study_file.hpp"

namespace shadefit {

/// A built-in family as a study: its form, its target on the surface of the options, its usual exponents, and
/// the best fits that were published for it. A published constant alone is a set of its own, for any
/// exponent. Throws UserError for options of a surface that do not apply.
StudyFile family_file(const NamedFit& named, const FitOptions& options);

/// The part of the range that counts for a relative error of a lobe: where it is at least 1/255, one code of
/// an 8-bit linear target. Throws UserError where that is below any double.
void narrow_to_visible(StudyFile& file);

}  // namespace shadefit
