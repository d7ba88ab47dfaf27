#pragma once

#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"

/// The alternation of a minimax fit, in words.
namespace shadefit {

/// 1 or -1 if the error is at the level on that side; 0 for the point of a constraint.
int sign_of_error(const AlternationPoint& point, const Constraints& constraints);

/// "level", or the active constraint: "form <= 1", "form = target".
std::string what_holds(const AlternationPoint& point, const Constraints& constraints);

/// "+ at c = 0.3, - at c = 0.7": where the error is at the level.
std::string level_places(const std::vector<AlternationPoint>& alternation, const Constraints& constraints,
                         const std::string& variable);

/// A line for each place where a constraint touches.
std::string touching_lines(const std::vector<AlternationPoint>& alternation, const Constraints& constraints,
                           const std::string& variable);

/// A line with the level and the places of the alternation, and one for each active constraint; empty for a
/// fit without an alternation.
std::string alternation_text(const Fit& fit);

}  // namespace shadefit
