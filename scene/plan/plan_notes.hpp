#pragma once

#include <string>
#include <vector>

#include "scene/plan/plan.hpp"

/// What a plan says beside its decisions.
namespace shadefit::scene {

/// What the plan does not count, what was changed, and what engines would change, a line each.
std::vector<std::string> notes_of(const Scene& scene, const Plan& plan);

}  // namespace shadefit::scene
