#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "reports/code/shader_code.hpp"
#include "scene/plan/plan.hpp"

/// Compute shaders of the specular term of a scene's materials: with the code that `scene --lang` writes, and
/// with full formulas for every term.
namespace shadefit::device {

/// A material as the shader reads it: each member is a word of 32 bits, in this order.
struct ShaderMaterial {
  std::array<float, 3> f0 = {}, f90 = {};
  float exponent = 0, sharpness = 0, normalisation = 0;
  float cutoff = 0;                                        ///< a light with a smaller n.h is dark
  scene::PowerTexture source = scene::PowerTexture::none;  ///< where the power of a pixel comes from
  std::uint32_t has_lobe = 0;                              ///< 1, or 0: the material stays black
  bool operator==(const ShaderMaterial&) const = default;
};

inline constexpr std::size_t words_of_material = 12;
using MaterialWords = std::array<std::uint32_t, words_of_material>;
static_assert(sizeof(ShaderMaterial) == sizeof(MaterialWords));

/// A way to shade a scene.
struct SceneShader {
  std::vector<ShaderFunction> functions;
  std::vector<ShaderMaterial> materials;
  bool is_coloured = true;  ///< false: only one channel is written
};

/// The shader of a plan, with its emitted functions. They compute in float, whatever precision the plan has.
SceneShader planned_shader(const scene::Scene& scene, scene::Plan plan);

/// Shaders that compute every term of every material that is not black: with pow and Schlick's formula, and
/// with the published constants. As on the CPU, a power that is not in a texture is prepared once for its
/// material.
SceneShader reference_shader(const scene::Scene& scene);
SceneShader published_shader(const scene::Scene& scene);

/// The value that a texture stores for a power: a roughness, a gloss, or the power itself.
float stored_of_power(double power, scene::PowerTexture source, const scene::Conventions& conventions);

/// The shader in GLSL, one thread for each pixel. Its push words are the first pixel, the number of pixels,
/// the number of lights of each, and P, the number of all pixels. The input has planes of P words: n.h, n.l,
/// l.h, the value of the texture, the material. After them come the materials. The output has a plane of P
/// floats for each channel: the sum of the lights, each limited to 1. The first light has the given cosines.
/// The others differ a little, so that the compiler cannot compute one light for all.
std::string glsl_of(const SceneShader& shader);

/// The number of planes of the input.
inline constexpr std::size_t planes_of_pixel = 5;

}  // namespace shadefit::device
