#pragma once

#include <vector>

#include "fit/better/better_study.hpp"
#include "reports/figures/figure.hpp"
#include "reports/studies/study_rows.hpp"

/// The figures of a study of one variable. Throw UserError for more variables.
namespace shadefit {

/// Target and form above, the error below, with the level of a minimax fit; one curve for each of the first
/// fits that converged, at most four. Throws UserError if none did.
Figure study_figure(const std::vector<FittedStudy>& studies);

/// The errors of the published sets, three at most, and of the best curve that beats one of them.
Figure better_study_figure(const StudyComparison& comparison);

}  // namespace shadefit
