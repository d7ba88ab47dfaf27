#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/better/better_study.hpp"

namespace shadefit {

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
