#pragma once

#include "fit/better/better_study.hpp"

namespace shadefit {

/// Proves bounds of the largest error, of relative width 1e-4, of each published contender and of what is
/// better at its cost. Without a proof stay measured rows, targets and forms that have none, and errors
/// for which 20 000 boxes (1500 if the target has an integral: each takes milliseconds) are too few; the last
/// have a wider upper bound alone.
void prove_contenders(StudyComparison& comparison, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
