#pragma once

#include <vector>

#include "fit/study/solve_study.hpp"

namespace shadefit {

/// The minimax fit of a study. In one variable by the exchange (fit/minimax/minimax.hpp), from its
/// least-squares fit and from other basins; the lowest level counts. In two and three by
/// `solve_minimax_surface`, of measured rows by `solve_minimax_rows`, both without constraints. Throws
/// UserError for constraints that the form cannot satisfy, and for those that do not go with rows or several
/// variables.
StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
