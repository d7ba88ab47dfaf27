#pragma once

#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

namespace shadefit {

/// An SVG with a map of the error over two variables for each contender, side by side on one scale: `form -
/// target`, or that divided by the target where the study has a relative error. The page colours the classes
/// `over` and `under`; a cell is as opaque as its error is large. Empty if the study does not have two
/// variables.
std::string heat_map_svg(const StudyComparison& comparison,
                         const std::vector<const StudyContender*>& contenders);

}  // namespace shadefit
