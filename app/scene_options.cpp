#include "app/scene_options.hpp"

#include <CLI/CLI.hpp>

namespace shadefit {
namespace {

/// How the files are read.
void add_conventions(CLI::App& scene, SceneOptions& options) {
  scene.add_option("--alpha", options.alpha, "what a roughness is: roughness-squared, or alpha = roughness")
      ->capture_default_str()
      ->type_name("NAME");
  scene
      .add_option("--min-roughness", options.min_roughness,
                  "takes smaller ones for it, as engines do: 0.045 Filament, 0.0525 three.js; default: none")
      ->type_name("R");
  scene.add_option("--gloss", options.gloss, "1 - roughness, or exponential: a power of 2^(10 g + 1)")
      ->capture_default_str()
      ->type_name("NAME");
  scene
      .add_option("--maps", options.maps,
                  "of a .mtl: named, as the format says, or pbr: map_Ka metallic, map_Ns roughness")
      ->capture_default_str()
      ->type_name("NAME");
}

/// What is wanted of the shading.
void add_wishes(CLI::App& scene, SceneOptions& options) {
  auto* tolerance = scene.add_option("--tolerance", options.tolerance,
                                     "of a pixel, all its lights together, in linear values; default: 1/255");
  tolerance->type_name("T");
  scene.add_option("--codes", options.codes, "the same in sRGB codes of 8 bits instead, 0.5 for example")
      ->type_name("C")
      ->excludes(tolerance);
  scene
      .add_option("--lights", options.lights,
                  "that may shine on one point; default: those of the files, else 1")
      ->type_name("N");
  scene.add_option("--precision", options.precision, "of the pixel: float or half")
      ->capture_default_str()
      ->type_name("NAME");
}

}  // namespace

CLI::App* add_scene_options(CLI::App& app, SceneOptions& options) {
  auto* scene = app.add_subcommand("scene", "what a scene's materials need, and what can be skipped");
  scene->add_option("file", options.files, "glTF (.gltf, .glb) or Wavefront (.mtl, .obj), one or more")
      ->required();
  add_wishes(*scene, options);
  add_conventions(*scene, options);
  auto* json = scene->add_flag("--json", options.json, "print JSON");
  auto* language = scene->add_option("--lang", options.language,
                                     "print the code in glsl, hlsl, c, cpp, wgsl or msl, and nothing else");
  language->type_name("NAME")->excludes(json);
  scene
      ->add_flag(
          "--shade", options.shade,
          "shade the materials by the reference, by published constants and as planned: times and errors")
      ->excludes(json)
      ->excludes(language);
  scene
      ->add_option(
          "--out", options.out,
          "directory to write the plan to, scene.md, .csv and .json, and its code, scene.glsl, .hlsl "
          "and .hpp")
      ->type_name("DIR")
      ->excludes(json)
      ->excludes(language);
  return scene;
}

}  // namespace shadefit
