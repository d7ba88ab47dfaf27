#pragma once

#include <vector>

#include "fit/study/study.hpp"

/// Starts for forms with waves, such as b sin(a x). A descent finds a frequency only from within about half a
/// period over the range; so it has to start there, and the target's own spectrum says where.
namespace shadefit {

/// A start for each of the frequencies at which the target is strongest: each parameter that a variable
/// multiplies inside a sine or cosine gets one of them, all others are 1. Empty if the form has none, or the
/// target no finite values.
std::vector<std::vector<double>> wave_starts(const ReadStudy& study);

}  // namespace shadefit
