#pragma once

#include "fit/better/better_study.hpp"

namespace shadefit {

/// Proves bounds of the largest error, of relative width 1e-4, of each published contender and of what is
/// better at its cost. Measured rows have no proof, and neither have targets and forms without intervals. A
/// proof may need more than 20 000 boxes, or 1500 if the target has an integral, where each box takes
/// milliseconds. Then the contender gets a wider upper bound alone.
void prove_contenders(StudyComparison& comparison, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
