#pragma once

#include <vector>

#include "fit/better/better_study.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/studies/study_rows.hpp"

/// The figures of a study of one or two variables. Throw UserError for more.
namespace shadefit {

/// Target and form above, the error below, over the first variable: a curve for each of the first fits that
/// converged, at most four. Of two variables: of the first fit, at four values of the second. The target of
/// measured rows is drawn as points. Throws UserError if no fit converged.
Figure study_figure(const std::vector<FittedStudy>& studies);

/// The errors of the published sets, three at most, and of the best curve that beats one of them. Of two
/// variables: at the value of the second where the error of the first set is largest.
Figure better_study_figure(const StudyComparison& comparison);

}  // namespace shadefit
