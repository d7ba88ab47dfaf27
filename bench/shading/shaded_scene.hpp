#pragma once

#include <optional>

#include "bench/shading/kernels/kernel.hpp"
#include "scene/plan/plan.hpp"

/// Materials in the form of the kernels.
namespace shadefit::shade {

/// With the largest reflectances of a material. If its format has no Fresnel term, F90 is F0, so that the
/// same shader works.
FullMaterial<double> full_material(const scene::Material& material);
FullMaterial<float> narrowed(const FullMaterial<double>& material);

/// A material of a plan; empty if it has no lobe. Constants are computed in double and rounded to float,
/// cut-offs downwards.
std::optional<PlannedMaterial> planned_material(const scene::Material& material,
                                                const scene::MaterialPlan& of_material,
                                                const scene::PlannedShading& shading);

/// The roughness of a power, as a texture stores it. 1 for a power of 0.
double alpha_of_power(double power);

}  // namespace shadefit::shade
