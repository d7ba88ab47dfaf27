#pragma once

#include <vector>

#include "fit/study/solve_study.hpp"

namespace shadefit {

/// Whether a study can have a minimax fit: its target is a formula.
bool can_be_minimax(const ReadStudy& study);

/// The minimax fit of a study. In one variable by the exchange (fit/minimax/minimax.hpp), from its
/// least-squares fit and from other basins; the lowest level counts. In two and three by
/// `solve_minimax_surface`, without constraints. Throws UserError for measured rows and for
/// constraints that the form cannot satisfy.
StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
