#pragma once

#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// The minimax fit of a study. In one variable the exchange (fit/panels/minimax.hpp) starts from the
/// least-squares fit and from other basins, and the lowest level counts: if the exchange does not settle
/// where the largest error is lowest, the fit is not converged, though it settled at a higher level
/// elsewhere. An exchange that runs to infinity also starts beyond it (`beyond_infinity`). Two and three
/// variables use `solve_minimax_surface`, measured rows `solve_minimax_rows`, both without constraints.
/// Throws UserError for constraints that the form cannot satisfy, or that rows or several variables cannot
/// have.
StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
