#pragma once

#include "fit/better/better_study.hpp"
#include "fit/bounds/study_certificate.hpp"

namespace shadefit {

/// What a proof about a contender is about: its form with the constants as printed, or with the doubles of a
/// fit.
StudySubject subject_of(const Study& study, const StudyContender& contender);

/// Proves the sampled properties of a contender, for a target whose largest magnitude is `size`
/// (fit/bounds/prove_shape.hpp). A property that is refuted is removed: the samples missed a place.
void prove_properties(const Study& study, double size, StudyContender& contender,
                      const Checkpoint& checkpoint = keep_going);

/// Proves bounds of the largest error, of relative width 1e-4, of each published contender and of what is
/// better at its cost. Measured rows have no proof, and neither have targets and forms without intervals. A
/// proof may need more than 20 000 boxes, or 1500 if the target has an integral, where each box takes
/// milliseconds. Then the contender gets a wider upper bound alone.
void prove_contenders(StudyComparison& comparison, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
