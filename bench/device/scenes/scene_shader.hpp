#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "reports/code/shader_code.hpp"
#include "scene/plan/plan.hpp"

/// The specular term of a scene's materials as compute shaders: by the code that `scene --lang` writes, and
/// the same with every term by other formulas.
namespace shadefit::device {

/// The source of a pixel's power.
enum class PowerSource : std::uint32_t { material, roughness, gloss, power };

PowerSource source_of(const scene::Material& material);

/// A material as the shader reads it: each member is a word of 32 bits, in this order.
struct ShaderMaterial {
  std::array<float, 3> f0 = {}, f90 = {};
  float exponent = 0, sharpness = 0, normalisation = 0;
  float cutoff = 0;  ///< below this n.h a light is dark
  PowerSource source = PowerSource::material;
  std::uint32_t has_lobe = 0;  ///< 1 or 0: it stays black
  bool operator==(const ShaderMaterial&) const = default;
};

inline constexpr std::size_t words_of_material = 12;
using MaterialWords = std::array<std::uint32_t, words_of_material>;
static_assert(sizeof(ShaderMaterial) == sizeof(MaterialWords));

/// A way to shade a scene.
struct SceneShader {
  std::vector<ShaderFunction> functions;
  std::vector<ShaderMaterial> materials;
  bool is_coloured = true;  ///< else one channel is written
};

/// By a plan, with its emitted functions. They compute in float, whatever the plan is for.
SceneShader planned_shader(const scene::Scene& scene, const scene::Plan& plan);

/// Every term for every material that is not black: by pow and Schlick's formula, and by the published
/// constants. As on the CPU, a power that no texture holds is prepared with its material.
SceneShader reference_shader(const scene::Scene& scene);
SceneShader published_shader(const scene::Scene& scene);

/// What a texture holds for a power: its roughness or gloss, or the power itself.
float stored_of_power(double power, PowerSource source, const scene::Conventions& conventions);

/// The shader in GLSL, a thread for each pixel. The push words are: the first pixel, how many pixels, how
/// many lights each, and P, the number of all pixels. The input has planes of P words: n.h, n.l, l.h, what a
/// texture holds, the material; then the materials. The output has a plane of P floats for each channel: the
/// sum of the lights, each limited to 1. The first light has the given cosines, and the next ones are nearly
/// the same, so that nothing is computed once for all.
std::string glsl_of(const SceneShader& shader);

/// Planes of the input.
inline constexpr std::size_t planes_of_pixel = 5;

}  // namespace shadefit::device
