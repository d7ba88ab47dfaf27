#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fit/study/study_problem.hpp"

namespace shadefit {

/// Whether only one set of parameters has the least level.
///
/// Each row of `slopes` is the gradient of |error| by the parameters, at a place where it is at the level.
/// Some rows, `support`, cancel each other with multipliers >= 0: no step lowers all these errors. A step
/// that raises none of the errors is possible only along rows whose multipliers are 0 in every such
/// combination. So the parameters are determined if the rows that can have a multiplier > 0 span all steps.
/// Other combinations are reached from the first one: a row enters with a small multiplier, and those of the
/// support fall. Source: the strict complementarity of Goldman, Tucker 1956, "Theory of linear programming",
/// in Linear Inequalities and Related Systems.
bool are_determined(const MatrixOf<double>& slopes, std::span<const std::size_t> support,
                    std::span<const double> multipliers);

}  // namespace shadefit
