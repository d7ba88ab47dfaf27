#pragma once

#include "fit/better/better_study.hpp"
#include "fit/study_proof/study_certificate.hpp"

namespace shadefit {

/// What a proof about a contender is about: its form with the constants as printed, or with the doubles of a
/// fit.
StudySubject subject_of(const Study& study, const StudyContender& contender);

/// Proves the sampled properties of a contender, for a target whose largest magnitude is `size`
/// (fit/study_proof/prove_shape.hpp). A property that is refuted is removed: the samples missed a place.
void prove_properties(const Study& study, double size, StudyContender& contender,
                      const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
