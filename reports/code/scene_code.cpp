#include "reports/code/scene_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/microfacet.hpp"
#include "approx/shading.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

using scene::LobeForm;
using scene::LobeKind;
using scene::Plan;
using scene::PowerTexture;
using scene::Scene;

/// A constant, limited to the largest half if the code computes in half.
Symbolic number_of(double value, scene::PixelPrecision precision) {
  constexpr double largest_half = 65504;
  const bool is_half = precision == scene::PixelPrecision::float16;
  return Symbolic::number(
      fmt::format("{}", is_half ? std::clamp(value, -largest_half, largest_half) : value));
}

bool has_texture(const Scene& scene, const Plan& plan, PowerTexture texture) {
  for (std::size_t i = 0; i < plan.materials.size(); ++i) {
    if (plan.materials[i].has_lobe && scene.materials[i].power_texture == texture) return true;
  }
  return false;
}

/// Whether all lobes have one power, and which.
std::optional<double> one_power(const Plan& plan) {
  std::optional<double> one;
  for (const scene::MaterialPlan& material : plan.materials) {
    if (!material.has_lobe) continue;
    if (!material.power.is_constant() || (one && *one != material.power.least)) return {};
    one = material.power.least;
  }
  return plan.shading.is_power_of_pixel ? std::nullopt : one;
}

/// A Gaussian of constant powers has its A computed with the material.
bool has_sharpness(const Plan& plan) {
  const LobeForm& lobe = plan.shading.lobe;
  return lobe.kind == LobeKind::exponential && lobe.slopes.size() == 1 && !plan.shading.is_power_of_pixel &&
         !one_power(plan);
}

/// The power of a pixel's stored value, as in `power_of_roughness`.
Symbolic power_of(const Symbolic& stored, const Scene& scene, const Plan& plan) {
  const double least = scene.conventions.min_roughness;
  const Symbolic roughness = least > 0 ? max(stored, number_of(least, plan.wanted.precision)) : stored;
  const Symbolic alpha = scene.conventions.is_roughness_squared ? roughness * roughness : roughness;
  return min(blinn_phong_exponent(alpha), number_of(scene::most_power, plan.wanted.precision));
}

ShaderFunction exponent_of_roughness(const Scene& scene, const Plan& plan) {
  return {"scene_exponent_of_roughness",
          {"roughness"},
          power_of(Symbolic::variable("roughness"), scene, plan),
          {"The power n of a pixel's roughness."}};
}

ShaderFunction exponent_of_gloss(const Scene& scene, const Plan& plan) {
  const Symbolic gloss = Symbolic::variable("gloss"), one = integer<Symbolic>(1);
  return {"scene_exponent_of_gloss",
          {"gloss"},
          scene.conventions.is_gloss_exponential ? decode_gloss(gloss, integer<Symbolic>(10), one)
                                                 : power_of(one - gloss, scene, plan),
          {"The power n of a pixel's gloss."}};
}

/// Limits the cosine to at least the smallest normal number if a power may be 0, because 0 times log2(0) =
/// -infinity would be NaN. This changes nothing visible: `seen_light` is as small.
Symbolic above_zero(const Plan& plan, const Symbolic& c) {
  const bool has_power_of_zero = std::ranges::any_of(
      plan.materials, [](const auto& material) { return material.has_lobe && material.power.least == 0; });
  if (!has_power_of_zero) return c;
  const bool is_float = plan.wanted.precision == scene::PixelPrecision::float32;
  return max(c, number_of(is_float ? std::numeric_limits<float>::min() : 0x1p-14, plan.wanted.precision));
}

/// The constants of the lobe: numbers for a single power, the material's sharpness, or slopes and the
/// exponent.
scene::LobeConstants<Symbolic> constants_of(const Plan& plan) {
  const LobeForm& lobe = plan.shading.lobe;
  const std::optional<double> power = one_power(plan);
  const Symbolic exponent = Symbolic::variable("exponent");
  if (lobe.kind == LobeKind::power) return {{}, power ? number_of(*power, plan.wanted.precision) : exponent};
  if (has_sharpness(plan)) return {{Symbolic::variable("sharpness")}, {}};
  scene::LobeConstants<Symbolic> constants;
  for (const double slope : lobe.slopes)
    constants.slopes.push_back(
        number_of(power ? (*power + lobe.offset) * slope : slope, plan.wanted.precision));
  if (!power)
    constants.exponent =
        lobe.offset == 0 ? exponent : exponent + number_of(lobe.offset, plan.wanted.precision);
  return constants;
}

Symbolic lobe_of(const Plan& plan, const Symbolic& c) {
  const LobeForm& lobe = plan.shading.lobe;
  return planned_lobe(lobe, lobe.kind == LobeKind::power ? above_zero(plan, c) : c, constants_of(plan));
}

ShaderFunction light(const Plan& plan, bool is_texel_a_power) {
  const Symbolic c = Symbolic::variable("n_dot_h"), n_dot_l = Symbolic::variable("n_dot_l");
  ShaderFunction function{"scene_light", {"n_dot_l"}, n_dot_l, {}};
  if (plan.shading.lobe.kind != LobeKind::constant)
    function.arguments.insert(function.arguments.begin(), "n_dot_h");
  const std::optional<double> power = one_power(plan);
  Symbolic normalisation = n_dot_l;
  if (power) {
    normalisation = number_of(game_normalisation(*power), plan.wanted.precision);
  } else if (has_sharpness(plan)) {
    function.arguments.insert(function.arguments.end(), {"sharpness", "normalisation"});
    normalisation = Symbolic::variable("normalisation");
  } else {
    function.arguments.emplace_back("exponent");
    normalisation = game_normalisation(Symbolic::variable("exponent"));
  }
  const Symbolic seen = plan.shading.lobe.kind == LobeKind::constant ? n_dot_l : seen_light(n_dot_l, c);
  function.result = normalisation * lobe_of(plan, c) * seen;
  function.comment = {fmt::format("The normalised lobe times n.l: {}.", to_text(plan.shading.lobe))};
  if (has_sharpness(plan))
    function.comment.emplace_back("Of a material: sharpness A, normalisation (n + 2)/8.");
  if (is_texel_a_power)
    function.comment.emplace_back("The exponent of a texture of powers is Ns times its texel.");
  return function;
}

ShaderFunction reflectance() {
  const Symbolic f0 = Symbolic::variable("f0"), f90 = Symbolic::variable("f90");
  return {"scene_reflectance",
          {"f0", "f90", "l_dot_h"},
          reflectance_between(f0, f90, schlick_weight(Symbolic::variable("l_dot_h"))),
          {"Schlick's reflectance, for each channel that differs."}};
}

std::vector<OthersText> comment_of(const Plan& plan, const std::string& command) {
  const bool in_codes = plan.wanted.scale == scene::ShownScale::codes;
  const bool is_constant = plan.shading.lobe.kind == LobeKind::constant;
  std::vector<OthersText> comment{std::string(generated_line), command, OthersText()};
  if (!plan.has_lobes()) {
    comment.emplace_back("No material of this scene needs a specular term.");
    return comment;
  }
  comment.emplace_back(plan.shading.has_fresnel
                           ? "The specular term of a light is scene_reflectance(..) scene_light(..)."
                           : "The specular term of a light is F0 scene_light(..).");
  comment.push_back(fmt::format(
      "Proven: {} clamped to [0, 1], at most {}{} from F (n + 2)/8 (n.h)^n {} in {}.",
      plan.wanted.lights == 1 ? "a light" : fmt::format("{} lights together, each", plan.wanted.lights),
      decimal_above(plan.error, 3), in_codes ? " sRGB codes" : "", is_constant ? "(n.l)" : "min(n.l, 2 n.h)",
      name(plan.wanted.precision)));
  if (plan.shading.lobe.kind == LobeKind::exponential || plan.shading.lobe.kind == LobeKind::power)
    comment.emplace_back(plan.wanted.precision == scene::PixelPrecision::float32
                             ? "With exp2 within 4 ulps, log2 within 3 or 2^-21."
                             : "With exp2 and log2 rounded once.");
  if (!plan.is_within()) comment.emplace_back("That is NOT within the tolerance.");
  if (!is_constant)
    comment.emplace_back(
        "min(n.l, 2 n.h) is n.l wherever n.v >= 0: it bounds a light where a normal map turns away.");
  comment.emplace_back("Cosines are in [0, 1]: to clamp them, and the sum of all lights, is the caller's.");
  return comment;
}

}  // namespace

std::vector<ShaderFunction> scene_functions(const Scene& scene, const Plan& plan) {
  std::vector<ShaderFunction> functions;
  if (!plan.has_lobes()) return functions;
  if (has_texture(scene, plan, PowerTexture::roughness))
    functions.push_back(exponent_of_roughness(scene, plan));
  if (has_texture(scene, plan, PowerTexture::gloss)) functions.push_back(exponent_of_gloss(scene, plan));
  functions.push_back(light(plan, has_texture(scene, plan, PowerTexture::power)));
  if (plan.shading.has_fresnel) functions.push_back(reflectance());
  return functions;
}

std::string scene_code(const Scene& scene, const Plan& plan, Language language, const std::string& command) {
  const std::vector<ShaderFunction> functions = scene_functions(scene, plan);
  const bool is_half = plan.wanted.precision == scene::PixelPrecision::float16;
  return shader_code(functions, language, is_half ? ShaderPrecision::float16 : ShaderPrecision::float32,
                     comment_of(plan, command));
}

}  // namespace shadefit
