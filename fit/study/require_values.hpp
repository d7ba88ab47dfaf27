#pragma once

#include "fit/study/study_nodes.hpp"

namespace shadefit {

/// Throws UserError, with the place, where the target has no finite value, where the weight is negative or
/// not finite, or of a row 0, and where a relative error divides by a zero of the target that the form does
/// not share. The last is seen inside the range of one variable, and at nodes where there are more.
void require_values(const ReadStudy& study, const StudyNodes& nodes);

}  // namespace shadefit
