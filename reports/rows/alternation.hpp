#pragma once

#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"

/// The alternation of a minimax fit, in words.
namespace shadefit {

/// "level", or the active constraint: "form <= 1", "form = target".
std::string what_holds(const AlternationPoint& point, const Constraints& constraints);

/// "+ at c = 0.3, - at c = 0.7": where the error is at the level.
std::string level_places(const std::vector<AlternationPoint>& alternation, const Constraints& constraints,
                         const std::string& variable);

/// A line for each place where a constraint touches.
std::string touching_lines(const std::vector<AlternationPoint>& alternation, const Constraints& constraints,
                           const std::string& variable);

}  // namespace shadefit
