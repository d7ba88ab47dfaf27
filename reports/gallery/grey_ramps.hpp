#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

namespace shadefit {

/// Of a study of two variables the value of the second one at which its ramps are drawn: where the codes of a
/// published set differ most from those of the target. Empty for other studies.
std::optional<double> seen_line(const StudyComparison& comparison, const StudyContender& published);

/// An SVG with the target and each contender as ramps of grey over the first variable, one above the other.
/// The values are linear and shown in 8-bit sRGB. Empty unless the target lies in [0, 1] and the first
/// contender differs from it by a code or more: a smaller difference is not visible. Empty for three
/// variables, for rows of one, and for rows of two that are no grid.
std::string grey_ramps_svg(const StudyComparison& comparison,
                           const std::vector<const StudyContender*>& contenders);

}  // namespace shadefit
