#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

/// The errors and the values of contenders, as pictures for a page.
namespace shadefit {

/// A text in an SVG.
std::string svg_text(double x, double y, const char* anchor, const std::string& words);

/// An SVG with a curve of form - target for each contender, in classes `curve-1`, `curve-2` .., which the
/// page colours. The error has the study's weight, and is relative if the study's is. Empty if the study has
/// several variables, or measured rows.
std::string error_curve_svg(const StudyComparison& comparison,
                            const std::vector<const StudyContender*>& contenders);

/// An SVG with an error map over two variables for each contender, side by side on one scale: `form -
/// target`, divided by the target if the study has a relative error. The page colours the classes `over` and
/// `under`; the larger the error, the more opaque the cell. Empty if the study does not have two variables.
std::string heat_map_svg(const StudyComparison& comparison,
                         const std::vector<const StudyContender*>& contenders);

struct GreyRamps {
  std::string svg;
  /// Of a study of two variables the value of the second one: where the codes of the first contender differ
  /// most from those of the target.
  std::optional<double> line = std::nullopt;
};

/// An SVG with the target and each contender as ramps of grey over the first variable, one above the other.
/// The values are linear and shown in 8-bit sRGB. Empty unless the target lies in [0, 1] and the first
/// contender differs from it by a code or more: a smaller difference is not visible. Empty for three
/// variables, for rows of one, and for rows of two that are no grid.
GreyRamps grey_ramps(const StudyComparison& comparison, const std::vector<const StudyContender*>& contenders);

}  // namespace shadefit
