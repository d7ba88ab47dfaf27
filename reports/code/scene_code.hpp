#pragma once

#include <string>
#include <vector>

#include "reports/code/shader_code.hpp"
#include "scene/plan/plan.hpp"

/// Generates the code of a plan for a scene.
namespace shadefit {

/// The functions of a plan; none if no material has a specular lobe:
/// - `scene_exponent_of_roughness(roughness)`, `scene_exponent_of_gloss(gloss)`: n of a pixel, if a texture
/// holds it;
/// - `scene_light(n_dot_h, n_dot_l ..)`: g t (n.l), g the normalisation and t the lobe; of a scene with
/// several
///   powers with the exponent n, or for a Gaussian of constant powers with `sharpness` and `normalisation`,
/// constants of the material; without n_dot_h if the lobe is a constant;
/// - `scene_reflectance(f0, f90, l_dot_h)`, if the Fresnel term is kept: for each channel.
/// The specular term is their product, or F0 times `scene_light`.
std::vector<ShaderFunction> scene_functions(const scene::Scene& scene, const scene::Plan& plan);

/// All functions in a language. The comment above them contains `command`, which generated them, and the
/// errors. The powers of the materials are in the plan.
/// Throws UserError like `shader_code`.
std::string scene_code(const scene::Scene& scene, const scene::Plan& plan, Language language,
                       const std::string& command);

}  // namespace shadefit
