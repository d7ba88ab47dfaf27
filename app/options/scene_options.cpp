#include <fmt/format.h>

#include "app/options/declare_options.hpp"
#include "app/options/option_values.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A parser of a finite number, or a quotient of two ("1/255"), above 0 and at most `most`.
auto share_of(double most) {
  return [most](const std::string& option, const std::string& text) {
    const std::size_t slash = text.find('/');
    double value = parse_finite(option, text.substr(0, slash));
    if (slash != std::string::npos) value /= parse_finite(option, text.substr(slash + 1));
    if (!(value > 0 && value <= most))
      throw UserError(fmt::format("{} '{}' must be greater than 0 and at most {}", option, text, most));
    return value;
  };
}

/// Adds the options for reading the files.
void add_conventions(CLI::App& scene, scene::Conventions& conventions) {
  add_choice(scene, "--alpha", conventions.is_roughness_squared,
             Choices<bool>{{"roughness", false}, {"roughness-squared", true}},
             "the alpha of the distribution: the roughness itself, or its square");
  add_choice(scene, "--gloss", conventions.is_gloss_exponential,
             Choices<bool>{{"roughness", false}, {"exponential", true}},
             "what a gloss g is: 1 - roughness, or the power 2^(10 g + 1)");
  add_choice(
      scene, "--maps", conventions.are_maps_pbr, Choices<bool>{{"named", false}, {"pbr", true}},
      "how the maps of a .mtl are read: as the format names them, or map_Ka as metallic and map_Ns as roughness");
  add_value(scene, "--min-roughness", conventions.min_roughness, share_of(1), "R",
            "the least roughness, as engines have it: 0.045 Filament, 0.0525 three.js (default: none)");
}

/// Adds the options for the tolerance and its use.
void add_wishes(CLI::App& scene, SceneOptions& options) {
  auto* tolerance = add_value(scene, "--tolerance", options.tolerance, share_of(1), "T",
                              "the error that a pixel may have, all lights together, in linear values "
                              "(default: 1/255)");
  constexpr double most_codes = 255;
  add_value(scene, "--codes", options.codes, share_of(most_codes), "C",
            "the tolerance in steps of an 8-bit sRGB value, instead of --tolerance; for example 0.5")
      ->excludes(tolerance);
  const auto parse_lights = [](const std::string& option, const std::string& text) {
    constexpr int most = 1'000'000;
    const double value = parse_finite(option, text);
    if (!(value >= 1 && value <= most && value == static_cast<int>(value)))
      throw UserError(fmt::format("{} '{}' must be a whole number from 1 to {}", option, text, most));
    return static_cast<int>(value);
  };
  add_value(scene, "--lights", options.lights, parse_lights, "N",
            "how many lights may shine on one point (default: those of the files, else 1)");
  add_choice(scene, "--precision", options.precision,
             Choices<scene::PixelPrecision>{{"float", scene::PixelPrecision::float32},
                                            {"half", scene::PixelPrecision::float16}},
             "the arithmetic of the pixel");
}

}  // namespace

/// Generated files list the options in this order.
void declare_scene(CLI::App& scene, SceneOptions& options) {
  scene
      .add_option("file", options.files,
                  "glTF (.gltf, .glb) or Wavefront (.mtl, .obj), or a folder of them, one or more")
      ->required()
      ->type_name("FILE");
  add_wishes(scene, options);
  add_conventions(scene, options.conventions);
  auto* json = scene.add_flag("--json", options.json, "print JSON");
  auto* language = add_choice(scene, "--lang", options.language, by_name(languages),
                              "print only the code, in this language")
                       ->excludes(json);
  auto* features =
      scene
          .add_flag(
              "--features", options.conventions.has_features,
              "print the features that each material needs by its values, and the sets of them that occur")
          ->excludes(language);
  add_value(scene, "--out", options.out, parse_text, "DIR",
            "the directory to write the plan to: scene.md, .csv, .json")
      ->excludes(json)
      ->excludes(language)
      ->excludes(features);
  add_force(scene, options.force);
}

}  // namespace shadefit
