#pragma once

#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

namespace shadefit {

/// An SVG with the target of one variable and each contender as ramps of grey, one above the other. The
/// values are linear and shown in 8-bit sRGB. Empty unless the target lies in [0, 1] and the first contender
/// differs from it by a code or more: a smaller difference is not visible.
std::string grey_ramps_svg(const StudyComparison& comparison,
                           const std::vector<const StudyContender*>& contenders);

}  // namespace shadefit
