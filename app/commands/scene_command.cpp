#include <fmt/format.h>

#include <filesystem>

#include "app/commands/commands.hpp"
#include "app/output/output_file.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/scene_code.hpp"
#include "reports/code/scene_plan.hpp"
#include "reports/io/files.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read_scene.hpp"

/// The subcommand `scene`.
namespace shadefit {
namespace {

scene::Wanted wanted_by(const SceneOptions& options) {
  scene::Wanted wanted{.precision = options.precision};
  if (options.tolerance) wanted.tolerance = *options.tolerance;
  if (options.codes) wanted.tolerance = *options.codes;
  if (options.codes) wanted.scale = scene::ShownScale::codes;
  if (options.lights) wanted.lights = *options.lights;
  return wanted;
}

}  // namespace

Outcome scene_command(const SceneOptions& options, const Watched& work) {
  scene::Wanted wanted = wanted_by(options);
  if (options.out) require_writable(*options.out);
  const std::vector<std::filesystem::path> paths(options.files.begin(), options.files.end());
  const scene::Scene scene = scene::read_scene(paths, options.conventions);
  if (scene.materials.empty()) throw UserError(fmt::format("'{}' holds no material", options.files.front()));
  if (options.conventions.has_features)
    return {0, options.json ? features_json(scene) : features_text(scene), ""};
  if (!options.lights && scene.lights > 0) wanted.lights = scene.lights;
  const scene::Plan plan = scene::make_plan(scene, wanted, work.checkpoint);
  const int exit_code = plan.is_within() ? 0 : 1;
  if (options.language) {
    std::vector<std::string> words = options.words;
    words.insert(words.begin() + 1, options.files.begin(), options.files.end());
    words.insert(words.end(), {"--lang", std::string(name(*options.language))});
    return {exit_code, scene_code(scene, plan, *options.language, command_text(words)), ""};
  }
  if (options.json) return {exit_code, plan_json(scene, plan), ""};
  std::string out = plan_text(scene, plan, options.terminal);
  std::function<void()> put;
  if (options.out) {
    const std::vector<File> files{{"scene.md", plan_markdown(scene, plan)},
                                  {"scene.csv", write_csv(decisions_table(plan), Precision::report)},
                                  {"scene.json", plan_json(scene, plan)}};
    out += fmt::format("\nPlan: {}: {}\n", printable(*options.out), joined(files, ", ", &File::name));
    put = prepare_output(*options.out, files, {}, options.force, work.checkpoint);
  }
  return {exit_code, out, "", put};
}

}  // namespace shadefit
