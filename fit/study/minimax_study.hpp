#pragma once

#include <vector>

#include "fit/study/solve_study.hpp"

namespace shadefit {

/// The minimax fit of a study of one variable by the exchange (fit/minimax/minimax.hpp), from its
/// least-squares fit and from other basins; the lowest level counts. A study of more variables, or of more
/// than `most_parameters` parameters, is an error of the user.
StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
