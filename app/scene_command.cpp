#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/generated_file.hpp"
#include "app/metric_options.hpp"
#include "app/output_folder.hpp"
#include "app/parse_name.hpp"
#include "app/scene_options.hpp"
#include "app/shade_scene.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/scene_code.hpp"
#include "reports/code/scene_plan.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read_scene.hpp"

/// The subcommand `scene`.
namespace shadefit {
namespace {

/// "0.004" or "1/255", above 0 and at most `most`.
double parse_share(const std::string& option, const std::string& text, double most) {
  const std::size_t slash = text.find('/');
  double value = parse_finite(option, text.substr(0, slash));
  if (slash != std::string::npos) value /= parse_finite(option, text.substr(slash + 1));
  if (!(value > 0 && value <= most))
    throw UserError(fmt::format("{} '{}' must be greater than 0 and at most {}", option, text, most));
  return value;
}

int parse_lights(const std::string& text) {
  const double value = parse_finite("--lights", text);
  constexpr double most = 1e6;
  if (!(value >= 1 && value <= most && value == static_cast<int>(value)))
    throw UserError(fmt::format("--lights '{}' must be a whole number from 1 to {}", text, most));
  return static_cast<int>(value);
}

/// The words of an option with two values; the second is the switch.
bool is_second(const std::string& option, const std::string& text,
               const std::array<std::string_view, 2>& words) {
  for (const std::string_view word : words) {
    if (text == word) return word == words[1];
  }
  throw UserError(fmt::format("{} '{}' is unknown: it must be {} or {}", option, text, words[0], words[1]));
}

scene::Conventions parse_conventions(const SceneOptions& options) {
  return {
      .is_roughness_squared = is_second("--alpha", options.alpha, {"roughness", "roughness-squared"}),
      .is_gloss_exponential = is_second("--gloss", options.gloss, {"roughness", "exponential"}),
      .are_maps_pbr = is_second("--maps", options.maps, {"named", "pbr"}),
      .min_roughness = options.min_roughness ? parse_share("--min-roughness", *options.min_roughness, 1) : 0};
}

scene::Wanted parse_wanted(const SceneOptions& options) {
  scene::Wanted wanted;
  if (options.tolerance) wanted.tolerance = parse_share("--tolerance", *options.tolerance, 1);
  if (options.codes) {
    constexpr double most_codes = 255;
    wanted.tolerance = parse_share("--codes", *options.codes, most_codes);
    wanted.scale = scene::ShownScale::codes;
  }
  if (options.lights) wanted.lights = parse_lights(*options.lights);
  wanted.precision = is_second("--precision", options.precision, {"float", "half"})
                         ? scene::PixelPrecision::float16
                         : scene::PixelPrecision::float32;
  return wanted;
}

/// A path from the folder of the code that names it, so that both can be moved together; from the root where
/// the code is printed and may be kept anywhere.
std::string recorded_path(const std::string& file, const std::optional<std::string>& folder) {
  const auto real = [](const std::filesystem::path& path) { return std::filesystem::weakly_canonical(path); };
  return (folder ? real(file).lexically_relative(real(without_detours(*folder))) : real(file)).string();
}

/// The command that prints the code: every option that is not as it is by default.
std::string code_command(const SceneOptions& options, Language language) {
  std::vector<std::string> words{"scene"};
  for (const std::string& file : options.files) words.push_back(recorded_path(file, options.out));
  const SceneOptions usual;
  const auto add = [&](const char* option, const std::string& value, const std::string& by_default = "") {
    if (value != by_default) words.insert(words.end(), {option, value});
  };
  add("--tolerance", options.tolerance.value_or(""));
  add("--codes", options.codes.value_or(""));
  add("--lights", options.lights.value_or(""));
  add("--precision", options.precision, usual.precision);
  add("--alpha", options.alpha, usual.alpha);
  add("--gloss", options.gloss, usual.gloss);
  add("--maps", options.maps, usual.maps);
  add("--min-roughness", options.min_roughness.value_or(""));
  add("--lang", std::string(name(language)));
  return command_text(words);
}

/// What --out writes.
std::vector<File> files_of(const SceneOptions& options, const scene::Scene& scene, const scene::Plan& plan) {
  std::vector<File> files{{"scene.md", plan_markdown(scene, plan)},
                          {"scene.csv", write_csv(decisions_table(plan), Precision::report)},
                          {"scene.json", plan_json(scene, plan)}};
  const auto add = [&](const char* file, Language language) {
    files.push_back({file, scene_code(scene, plan, language, code_command(options, language))});
  };
  add("scene.glsl", Language::glsl);
  add("scene.hlsl", Language::hlsl);
  // C++ has no half.
  if (plan.wanted.precision == scene::PixelPrecision::float32) add("scene.hpp", Language::cpp);
  return files;
}

/// Of another plan, if they are there, and what they begin with.
std::vector<File> not_written(const SceneOptions& options, const scene::Plan& plan) {
  std::vector<File> files;
  if (plan.wanted.precision == scene::PixelPrecision::float16)
    files.push_back({"scene.hpp", fmt::format("// {}\n", generated_line)});
  if (!options.shade) {
    const std::vector<File> shaded = files_of_shading();
    files.insert(files.end(), shaded.begin(), shaded.end());
  }
  return files;
}

std::string written(const std::string& directory, const std::vector<File>& files) {
  std::vector<std::string> names;
  for (const File& file : files) names.push_back(file.name);
  return fmt::format("\nPlan: {}: {}\n", printable(without_detours(directory).string()),
                     fmt::join(names, ", "));
}

}  // namespace

Outcome scene_command(const SceneOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const scene::Conventions conventions = parse_conventions(options);
  scene::Wanted wanted = parse_wanted(options);
  const auto language = [&] { return parse_name("--lang", *options.language, languages); };
  if (options.language) language();  // refused before a file is read
  std::optional<OutputFolder> folder;
  if (options.out) folder.emplace(*options.out);
  const std::vector<std::filesystem::path> paths(options.files.begin(), options.files.end());
  const scene::Scene scene = scene::read_scene(paths, conventions);
  if (scene.materials.empty()) throw UserError(fmt::format("'{}' holds no material", options.files.front()));
  if (!options.lights && scene.lights > 0) wanted.lights = scene.lights;
  const scene::Plan plan = scene::make_plan(scene, wanted, checkpoint);
  int exit_code = plan.is_within() ? 0 : 1;
  if (options.language)
    return {exit_code, scene_code(scene, plan, language(), code_command(options, language())), ""};
  if (options.json) return {exit_code, plan_json(scene, plan), ""};
  std::string out = plan_text(scene, plan);
  ShadedScene shaded;
  if (options.shade) {
    shaded = shade_scene(scene, plan, options.out, checkpoint, progress);
    out += "\n" + shaded.out;
    exit_code = std::max(exit_code, shaded.err.empty() ? 0 : 1);
  }
  std::function<void()> put;
  if (options.out) {
    std::vector<File> files = files_of(options, scene, plan);
    out += written(*options.out, files);
    files.insert(files.end(), shaded.files.begin(), shaded.files.end());
    std::vector<File> obsolete = not_written(options, plan);
    obsolete.insert(obsolete.end(), shaded.missing.begin(), shaded.missing.end());
    put = folder->prepare(files, obsolete, options.force, checkpoint);
  }
  return {exit_code, out, shaded.err, put};
}

}  // namespace shadefit
