#include <fmt/format.h>

#include <array>
#include <string_view>

#include "app/commands.hpp"
#include "app/metric_options.hpp"
#include "fit/user_error.hpp"
#include "reports/files.hpp"
#include "reports/scene_plan.hpp"
#include "reports/utf8.hpp"
#include "reports/writers.hpp"
#include "scene/plan.hpp"
#include "scene/read_scene.hpp"

/// The subcommand `scene`.
namespace shadefit {
namespace {

/// "0.004" or "1/255", above 0 and at most 1.
double parse_tolerance(const std::string& text) {
  const std::size_t slash = text.find('/');
  double value = parse_finite("--tolerance", text.substr(0, slash));
  if (slash != std::string::npos) value /= parse_finite("--tolerance", text.substr(slash + 1));
  if (!(value > 0 && value <= 1))
    throw UserError(fmt::format("--tolerance '{}' must be greater than 0 and at most 1", text));
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

}  // namespace

Outcome scene_command(const SceneOptions& options, const Checkpoint& checkpoint) {
  const scene::Conventions conventions{
      .is_roughness_squared = is_second("--alpha", options.alpha, {"roughness", "roughness-squared"}),
      .is_gloss_exponential = is_second("--gloss", options.gloss, {"roughness", "exponential"}),
      .are_maps_pbr = is_second("--maps", options.maps, {"named", "pbr"})};
  scene::Wanted wanted{.tolerance = parse_tolerance(options.tolerance)};
  if (options.lights) wanted.lights = parse_lights(*options.lights);
  if (options.out) require_directory(*options.out);
  const std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
  const scene::Scene scene = scene::read_scene(files, conventions);
  if (scene.materials.empty()) throw UserError(fmt::format("'{}' holds no material", options.files.front()));
  if (!options.lights && scene.lights > 0) wanted.lights = scene.lights;
  const scene::Plan plan = scene::make_plan(scene, wanted, checkpoint);
  const int exit_code = plan.is_within() ? 0 : 1;
  if (options.json) return {exit_code, plan_json(scene, plan), ""};
  std::string out = plan_text(scene, plan);
  if (options.out) {
    write_files(*options.out,
                {{"scene.md", plan_markdown(scene, plan)},
                 {"scene.csv", write_csv(decisions_table(plan), Precision::report)},
                 {"scene.json", plan_json(scene, plan)}},
                checkpoint);
    out += fmt::format("\nPlan: {}, scene.csv, scene.json\n",
                       printable((without_detours(*options.out) / "scene.md").string()));
  }
  return {exit_code, out, ""};
}

}  // namespace shadefit
