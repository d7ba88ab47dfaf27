#pragma once

#include <cstddef>

#include "fit/scalars/narrow_result.hpp"
#include "fit/study_proof/study_certificate.hpp"
#include "fit/support/checkpoint.hpp"

/// What the evaluation of a study's form in float or half adds to its error.
namespace shadefit {

/// The most boxes of such a bound. In float it is less than a hundredth of most errors, so a rough one is
/// enough.
inline constexpr std::size_t most_rounding_boxes = 2'000;

/// A proven bound of |weight * (computed - true)|, or that divided by the target, at every number of the
/// format in the ranges: of a form whose constants, numbers, operations and functions are all rounded to the
/// nearest one, a multiplication with an addition fused or not. So it bounds, with a bound of the error in
/// real numbers, the error in the format. Infinite if none was found, as for a form with an integral. The
/// subject must have no `fault_of`; the checkpoint is called for each box that is cut.
template <class Format>
double bound_of_rounding(const StudySubject& subject, const Checkpoint& checkpoint = keep_going,
                         std::size_t box_limit = most_rounding_boxes);

extern template double bound_of_rounding<FloatFormat>(const StudySubject&, const Checkpoint&, std::size_t);
extern template double bound_of_rounding<HalfFormat>(const StudySubject&, const Checkpoint&, std::size_t);

}  // namespace shadefit
