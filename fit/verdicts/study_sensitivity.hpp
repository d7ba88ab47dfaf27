#pragma once

#include <string>
#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/sensitivity.hpp"
#include "fit/verdicts/study_verdict.hpp"

/// The digits of a study's constants that matter.
namespace shadefit {

/// A fit whose objective differs in one respect.
struct OtherStudy {
  std::string under;  ///< "least squares, measure angle", "least squares, x in 0.1:1"
  StudyFit fit;
};

struct StudySensitivity {
  Sensitivity constants;
  std::vector<OtherStudy> others = {};  ///< the own fit first; of one variable
};

/// The sensitivity of a converged fit. The other objectives are the measures of a cosine if the range is
/// inside [0, 1], then ranges without a tenth at one end or both. Throws UserError for constraints, because
/// rounded constants do not meet them, and for measured rows, because their fits have profile intervals.
StudySensitivity sensitivity_of(const StudyObjective& objective, const StudyFit& fit,
                                const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
