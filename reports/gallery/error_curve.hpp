#pragma once

#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

/// The error curves of contenders of one variable, as a picture for a page.
namespace shadefit {

/// An SVG with a curve of form - target for each contender, in classes `curve-1`, `curve-2` .., which the
/// page colours. The error has the study's weight, and is relative if the study's is. Empty if the study has
/// several variables, or measured rows.
std::string error_curve_svg(const StudyComparison& comparison,
                            const std::vector<const StudyContender*>& contenders);

}  // namespace shadefit
