#pragma once

#include <cstddef>

#include "fit/bounds/study_certificate.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "fit/support/checkpoint.hpp"

/// How much the evaluation of a study's form in float or half adds to its error.
namespace shadefit {

/// The most boxes for this bound. In float it is less than a hundredth of most errors, so a rough one is
/// enough.
inline constexpr std::size_t most_rounding_boxes = 2'000;

/// A proven bound of |weight * (computed - true)|, divided by the target if the error is relative, at every
/// number of the format in the ranges. The form's constants, numbers, operations and functions are all
/// rounded to the nearest one; a multiply-add may be fused or not. Together with a bound of the error in real
/// numbers it bounds the error in the format. Infinite if none was found, as for a form with an integral.
/// With a `gpu` it is the bound for that device. `fault_of` must find no fault in the subject. The checkpoint
/// is called for each box that is cut.
template <class Format>
double bound_of_rounding(const StudySubject& subject, const Checkpoint& checkpoint = keep_going,
                         std::size_t box_limit = most_rounding_boxes, const GpuModel* gpu = nullptr);

extern template double bound_of_rounding<FloatFormat>(const StudySubject&, const Checkpoint&, std::size_t,
                                                      const GpuModel*);
extern template double bound_of_rounding<HalfFormat>(const StudySubject&, const Checkpoint&, std::size_t,
                                                     const GpuModel*);

}  // namespace shadefit
