#pragma once

#include <cstddef>

#include "fit/study_proof/study_certificate.hpp"
#include "fit/support/checkpoint.hpp"

/// How much the evaluation of a study's form in float adds to its error.
namespace shadefit {

/// The most boxes for this bound. It is less than a hundredth of most errors, so a rough one is enough.
inline constexpr std::size_t most_rounding_boxes = 2'000;

/// A proven bound of |weight * (computed - true)|, divided by the target if the error is relative, at every
/// float of the ranges. The form's constants, numbers, operations and functions are all rounded to the
/// nearest float; a multiply-add may be fused or not. Together with a bound of the error in real numbers it
/// bounds the error in float. Infinite if none was found, as for a form with an integral. `fault_of` must
/// find no fault in the subject. The checkpoint is called for each box that is cut.
double bound_of_float_rounding(const StudySubject& subject, const Checkpoint& checkpoint = keep_going,
                               std::size_t box_limit = most_rounding_boxes);

}  // namespace shadefit
