#pragma once

#include <cstddef>

#include "fit/study_proof/study_certificate.hpp"
#include "fit/support/checkpoint.hpp"

/// What the evaluation of a study's form in float adds to its error.
namespace shadefit {

/// The most boxes of such a bound. It is less than a hundredth of most errors, so a rough one is enough.
inline constexpr std::size_t most_rounding_boxes = 2'000;

/// A proven bound of |weight * (computed - true)|, or that divided by the target, at every float of the
/// ranges: of a form whose constants, numbers, operations and functions are all rounded to the nearest float,
/// a multiplication with an addition fused or not. So it bounds, with a bound of the error in real numbers,
/// the error in float. Infinite if none was found, as for a form with an integral. The subject must have no
/// `fault_of`; the checkpoint is called for each box that is cut.
double bound_of_float_rounding(const StudySubject& subject, const Checkpoint& checkpoint = keep_going,
                               std::size_t box_limit = most_rounding_boxes);

}  // namespace shadefit
