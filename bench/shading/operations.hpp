#pragma once

#include "bench/shading/kernels/kernel.hpp"
#include "scene/plan/plan.hpp"

/// What a sample costs, counted in operations of a shader; EXP2 and LOG2 are four each.
namespace shadefit::shade {

/// Of the reference's three channels, the power's decoding and normalisation among them where it is the
/// pixel's.
int full_operations(bool is_power_of_pixel);

/// Of a sample that a plan does not cull.
int planned_operations(const PlannedMaterial& material);

}  // namespace shadefit::shade
