#pragma once

#include <string>
#include <vector>

#include "scene/plan/plan.hpp"

/// The notes of a plan.
namespace shadefit::scene {

/// What the plan does not cover, what was changed, and what engines would change, one line each.
std::vector<std::string> notes_of(const Scene& scene, const Plan& plan);

}  // namespace shadefit::scene
