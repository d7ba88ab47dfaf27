#pragma once

#include <span>

#include "fit/rounding/study_in_format.hpp"

namespace shadefit {

/// The largest error of a form with constants of the format, over every number of the format in the range of
/// its one variable, and the first place that has it of those that were evaluated. `study` is that of
/// `in_format`, which has a sample of the places. A range of numbers is left out if an enclosure of the
/// rounded form and of the target shows that no number in it has a larger error; so it takes long only if
/// rounding makes most of the error. The checkpoint is called often. Throws std::logic_error for an albedo in
/// the target or the weight.
template <class Format>
ErrorInFormat largest_of_every_number(const ReadStudy& study, StudyInFormat<Format>& in_format,
                                      std::span<const double> constants,
                                      const Checkpoint& checkpoint = keep_going);

extern template ErrorInFormat largest_of_every_number(const ReadStudy&, StudyInFormat<HalfFormat>&,
                                                      std::span<const double>, const Checkpoint&);
extern template ErrorInFormat largest_of_every_number(const ReadStudy&, StudyInFormat<FloatFormat>&,
                                                      std::span<const double>, const Checkpoint&);

}  // namespace shadefit
