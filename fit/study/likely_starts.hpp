#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fit/study/study.hpp"

/// What a form and its target say about where a search has to start. A descent finds a frequency only from
/// within about half a period over the range, and a peak only from beside it.
namespace shadefit {

/// A start for each of the frequencies at which the target is strongest: each parameter that a variable
/// multiplies inside a sine or cosine gets one of them, all others are 1. Empty if the form has none, or the
/// target no finite values.
std::vector<std::vector<double>> wave_starts(const ReadStudy& study);

/// The range of a variable for each parameter that is subtracted from it, as d of (x - d)^2. Empty if the
/// form has none.
std::vector<std::optional<std::array<double, 2>>> positions_of(const ReadStudy& study);

}  // namespace shadefit
