#pragma once

#include "bench/shading/kernels/kernel.hpp"
#include "scene/plan/plan.hpp"

/// The cost of a sample in operations of a shader; EXP2 and LOG2 count as four each.
namespace shadefit::shade {

/// For the reference's three channels, with the decoding and the normalisation of a power that belongs to the
/// pixel.
int full_operations(bool is_power_of_pixel);

/// For a sample that a plan does not cull.
int planned_operations(const PlannedMaterial& material);

}  // namespace shadefit::shade
