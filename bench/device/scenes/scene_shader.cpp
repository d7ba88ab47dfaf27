#include "bench/device/scenes/scene_shader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bench/device/vulkan_device.hpp"
#include "bench/shading/kernels/full_terms.hpp"
#include "bench/shading/shaded_scene.hpp"
#include "bench/shading/ways.hpp"
#include "reports/code/scene_code.hpp"

namespace shadefit::device {
namespace {

Symbolic named(const char* name) {
  return Symbolic::variable(name);
}

/// A material with its reflectances and its power.
ShaderMaterial material_of(const scene::Material& material) {
  const shade::FullMaterial<double> full = shade::full_material(material);
  const shade::FullMaterial<float> narrow = shade::narrowed(full);
  return {.f0 = narrow.f0,
          .f90 = narrow.f90,
          .exponent = narrow.power,
          .normalisation = static_cast<float>(game_normalisation(full.power)),
          .source = material.power_texture,
          .has_lobe = shade::is_black(material) ? 0U : 1U};
}

/// The functions that decode a power, from the code of a plan in which every material has a lobe.
std::vector<ShaderFunction> decoding_functions(const scene::Scene& scene) {
  scene::Plan plan;
  plan.shading.lobe.kind = scene::LobeKind::constant;
  for (const scene::Material& material : scene.materials)
    plan.materials.push_back({.name = material.name, .has_lobe = !shade::is_black(material), .reason = ""});
  std::vector<ShaderFunction> functions = scene_functions(scene, plan);
  std::erase_if(functions, [](const ShaderFunction& function) {
    return !function.name.starts_with("scene_exponent_of_");
  });
  return functions;
}

/// The functions have the same names as a plan's. `scene_sharpness` and `scene_normalisation` serve a power
/// that a texture gives per pixel.
template <class Forms>
SceneShader full_shader(const scene::Scene& scene) {
  SceneShader shader{.functions = decoding_functions(scene), .materials = {}};
  const auto prepared = Forms::prepared(named("exponent"));
  shader.functions.push_back({"scene_sharpness", {"exponent"}, prepared.lobe});
  shader.functions.push_back({"scene_normalisation", {"exponent"}, prepared.normalisation});
  shader.functions.push_back(
      {"scene_light",
       {"n_dot_h", "n_dot_l", "sharpness", "normalisation"},
       named("normalisation") * Forms::lobe(named("n_dot_h"), named("sharpness")) * named("n_dot_l")});
  shader.functions.push_back(
      {"scene_reflectance",
       {"f0", "f90", "l_dot_h"},
       reflectance_between(named("f0"), named("f90"), Forms::weight(named("l_dot_h")))});
  for (const scene::Material& material : scene.materials) {
    ShaderMaterial made = material_of(material);
    made.sharpness = static_cast<float>(Forms::prepared(material.powers.front().power).lobe);
    shader.materials.push_back(made);
  }
  return shader;
}

const ShaderFunction* find(const SceneShader& shader, std::string_view name) {
  const auto found = std::ranges::find(shader.functions, name, &ShaderFunction::name);
  return found == shader.functions.end() ? nullptr : &*found;
}

/// Code that decodes the exponent of a pixel. Without a plan it also computes sharpness and normalisation.
std::string decoding_lines(const SceneShader& shader) {
  std::string lines = fmt::format("  if (source == {}u) exponent = stored;\n",
                                  static_cast<std::uint32_t>(scene::PowerTexture::power));
  const auto decode = [&](const char* function, scene::PowerTexture source) {
    if (find(shader, function) == nullptr) return;
    lines += fmt::format("  if (source == {}u) exponent = {}(stored);\n", static_cast<std::uint32_t>(source),
                         function);
  };
  decode("scene_exponent_of_roughness", scene::PowerTexture::roughness);
  decode("scene_exponent_of_gloss", scene::PowerTexture::gloss);
  if (find(shader, "scene_sharpness") != nullptr)
    lines +=
        "  if (source != 0u) {\n"
        "    sharpness = scene_sharpness(exponent);\n"
        "    normalisation = scene_normalisation(exponent);\n"
        "  }\n";
  return lines;
}

/// The call of `scene_light`. Its parameters have the names of the shader's variables.
std::string light_of(const SceneShader& shader) {
  const ShaderFunction* const light = find(shader, "scene_light");
  return light == nullptr ? "0.0" : fmt::format("scene_light({})", fmt::join(light->arguments, ", "));
}

std::string channel_of(const SceneShader& shader, char channel) {
  const std::string reflectance = find(shader, "scene_reflectance") == nullptr
                                      ? fmt::format("f0.{}", channel)
                                      : fmt::format("scene_reflectance(f0.{0}, f90.{0}, l_dot_h)", channel);
  return fmt::format("      sum.{} += min({} * light, 1.0);\n", channel, reflectance);
}

}  // namespace

SceneShader planned_shader(const scene::Scene& scene, scene::Plan plan) {
  plan.wanted.precision = scene::PixelPrecision::float32;
  SceneShader shader{
      .functions = scene_functions(scene, plan), .materials = {}, .is_coloured = plan.shading.is_coloured};
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    ShaderMaterial made = material_of(scene.materials[i]);
    const double power = scene.materials[i].powers.front().power;
    made.sharpness = static_cast<float>((power + plan.shading.lobe.offset) * scene::natural_slope);
    const auto planned = shade::planned_material(scene.materials[i], plan.materials[i], plan.shading);
    made.cutoff = planned ? planned->cutoff : 0;
    made.has_lobe = plan.materials[i].has_lobe ? 1 : 0;
    shader.materials.push_back(made);
  }
  return shader;
}

SceneShader reference_shader(const scene::Scene& scene) {
  return full_shader<shade::ReferenceForms>(scene);
}

SceneShader published_shader(const scene::Scene& scene) {
  return full_shader<shade::PublishedForms>(scene);
}

float stored_of_power(double power, scene::PowerTexture source, const scene::Conventions& conventions) {
  if (source == scene::PowerTexture::power || source == scene::PowerTexture::none)
    return static_cast<float>(power);
  // The inverse of `decode_gloss` with 10 doublings from 2.
  if (source == scene::PowerTexture::gloss && conventions.is_gloss_exponential)
    return static_cast<float>((std::log2(power) - 1) / 10);
  const double alpha = shade::alpha_of_power(power);
  const double roughness = conventions.is_roughness_squared ? std::sqrt(alpha) : alpha;
  return static_cast<float>(source == scene::PowerTexture::gloss ? 1 - roughness : roughness);
}

std::string glsl_of(const SceneShader& shader) {
  std::string sums, written;
  for (std::size_t i = 0; i < (shader.is_coloured ? 3U : 1U); ++i) {
    sums += channel_of(shader, "xyz"[i]);
    written += fmt::format("  shown[{}u * push.pixels + at] = sum.{};\n", i, "xyz"[i]);
  }
  return fmt::format(
      "#version 450\n"
      "layout(local_size_x = {0}) in;\n"
      "layout(set = 0, binding = 0, std430) writeonly buffer Output {{ float shown[]; }};\n"
      "layout(set = 0, binding = 1, std430) readonly buffer Input {{ uint given[]; }};\n"
      "layout(push_constant) uniform Push {{ uint from, size, lights, pixels; }} push;\n\n"
      "{1}\n"
      "float number(uint at) {{ return uintBitsToFloat(given[at]); }}\n"
      "vec3 colour(uint at) {{ return vec3(number(at), number(at + 1u), number(at + 2u)); }}\n\n"
      "void shade(uint at) {{\n"
      "  float given_n_dot_h = number(at), given_n_dot_l = number(push.pixels + at);\n"
      "  float given_l_dot_h = number(2u * push.pixels + at), stored = number(3u * push.pixels + at);\n"
      "  uint material = {2}u * push.pixels + {3}u * given[4u * push.pixels + at];\n"
      "  vec3 f0 = colour(material), f90 = colour(material + 3u);\n"
      "  float exponent = number(material + 6u), sharpness = number(material + 7u);\n"
      "  float normalisation = number(material + 8u), cutoff = number(material + 9u);\n"
      "  uint source = given[material + 10u];\n"
      "  uint lights = given[material + 11u] * push.lights;\n"
      "{4}"
      "  vec3 sum = vec3(0.0);\n"
      "  for (uint i = 0u; i < lights; ++i) {{\n"
      "    float nearly = 1.0 - float(i & 15u) * 0.00000095367431640625;\n"
      "    float n_dot_h = given_n_dot_h * nearly;\n"
      "    if (n_dot_h >= cutoff) {{\n"
      "      float n_dot_l = given_n_dot_l * nearly, l_dot_h = given_l_dot_h * nearly;\n"
      "      float light = {5};\n"
      "{6}"
      "    }}\n"
      "  }}\n"
      "{7}"
      "}}\n\n"
      "void main() {{\n"
      "  uint i = gl_GlobalInvocationID.x;\n"
      "  if (i < push.size) shade(push.from + i);\n"
      "}}\n",
      threads_per_group,
      shader_code(shader.functions, Language::glsl, ShaderPrecision::float32, std::array<OthersText, 0>()),
      planes_of_pixel, words_of_material, decoding_lines(shader), light_of(shader), sums, written);
}

}  // namespace shadefit::device
