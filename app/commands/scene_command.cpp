#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/options/scene_options.hpp"
#include "app/output/output_file.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/scene_code.hpp"
#include "reports/code/scene_features.hpp"
#include "reports/code/scene_plan.hpp"
#include "reports/io/files.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"
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

/// A path relative to the folder of the code that names it, so that both can be moved together. Absolute if
/// the code is printed, because it may be stored anywhere.
std::string recorded_path(const std::string& file, const std::optional<std::string>& folder) {
  // weakly_canonical leaves a relative path relative where its folder does not exist yet, as that of --out.
  const auto real = [](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  return (folder ? real(file).lexically_relative(real(*folder)) : real(file)).string();
}

/// The command that prints the code.
std::string code_command(const SceneOptions& options, Language language) {
  std::vector<std::string> words = options.words;
  std::vector<std::string> files;
  for (const std::string& file : options.files) files.push_back(recorded_path(file, options.out));
  words.insert(words.begin() + 1, files.begin(), files.end());
  words.insert(words.end(), {"--lang", std::string(name(language))});
  return command_text(words);
}

/// The files that --out writes.
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

/// Files of another plan that may exist, each with its first bytes.
std::vector<File> not_written(const scene::Plan& plan) {
  std::vector<File> files;
  if (plan.wanted.precision == scene::PixelPrecision::float16)
    files.push_back({"scene.hpp", fmt::format("// {}\n", generated_line)});
  return files;
}

std::string written(const std::string& directory, const std::vector<File>& files) {
  return fmt::format("\nPlan: {}: {}\n", printable(directory), joined(files, ", ", &File::name));
}

}  // namespace

Outcome scene_command(const SceneOptions& options, const Checkpoint& checkpoint) {
  scene::Wanted wanted = wanted_by(options);
  std::optional<OutputFolder> folder;
  if (options.out) folder.emplace(*options.out);
  const std::vector<std::filesystem::path> paths(options.files.begin(), options.files.end());
  const scene::Scene scene = scene::read_scene(paths, options.conventions);
  if (scene.materials.empty()) throw UserError(fmt::format("'{}' holds no material", options.files.front()));
  if (options.conventions.has_features)
    return {0, options.json ? features_json(scene) : features_text(scene), ""};
  if (!options.lights && scene.lights > 0) wanted.lights = scene.lights;
  const scene::Plan plan = scene::make_plan(scene, wanted, checkpoint);
  const int exit_code = plan.is_within() ? 0 : 1;
  if (options.language)
    return {exit_code, scene_code(scene, plan, *options.language, code_command(options, *options.language)),
            ""};
  if (options.json) return {exit_code, plan_json(scene, plan), ""};
  std::string out = plan_text(scene, plan, options.terminal);
  std::function<void()> put;
  if (options.out) {
    const std::vector<File> files = files_of(options, scene, plan);
    out += written(*options.out, files);
    put = folder->prepare(files, not_written(plan), options.force, checkpoint);
  }
  return {exit_code, out, "", put};
}

}  // namespace shadefit
