#pragma once

#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

namespace shadefit {

/// An SVG with an error map over two variables for each contender, side by side on one scale: `form -
/// target`, divided by the target if the study has a relative error. The page colours the classes `over` and
/// `under`; the larger the error, the more opaque the cell. Empty if the study does not have two variables.
std::string heat_map_svg(const StudyComparison& comparison,
                         const std::vector<const StudyContender*>& contenders);

}  // namespace shadefit
