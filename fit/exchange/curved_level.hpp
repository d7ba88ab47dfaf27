#pragma once

#include <optional>
#include <vector>

#include "fit/exchange/surface_programme.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// The least level of a form that is not linear, where fewer tops hold it than determine the parameters by
/// their slopes: the curvature of the error determines the rest.
///
/// The errors at the tops so far are lowered as those of measured rows are (fit/squares/row_descent.hpp),
/// and the tops of the result are added, until they are hardly higher than the level. Then Newton's method
/// follows the tops, which move with the parameters. `start` is near the answer; `places` determine the
/// parameters. Empty if this does not settle.
std::optional<StudyFit> curved_level(const ReadStudy& study, const Edges& edges, Places places,
                                     const std::vector<double>& start, const Checkpoint& checkpoint);

}  // namespace shadefit
