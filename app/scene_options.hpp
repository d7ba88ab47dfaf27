#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/progress.hpp"

namespace CLI {
class App;
}

/// What the subcommand `scene` is told.
namespace shadefit {

struct SceneOptions {
  std::vector<std::string> files;
  std::optional<std::string> tolerance;      ///< in linear values; empty: 1/255
  std::optional<std::string> codes;          ///< the tolerance in sRGB codes instead
  std::optional<std::string> lights;         ///< empty: as many as the files name, else 1
  std::optional<std::string> min_roughness;  ///< empty: 0, as files have it
  std::string precision = "float";
  std::string alpha = "roughness-squared", gloss = "roughness", maps = "named";
  std::optional<std::string> language;  ///< prints the code in it alone
  std::optional<std::string> out;       ///< a directory; empty: printed alone
  bool json = false;
  bool force = false;  ///< as of `RunOptions`
  bool shade = false;  ///< the plan against the reference and the published constants
};

/// Declares the subcommand.
CLI::App* add_scene_options(CLI::App& app, SceneOptions& options);

/// Reads the scene and plans its shading; with --shade measures it. Exit 1 where the plan is not within the
/// tolerance, or what is measured not within the plan.
Outcome scene_command(const SceneOptions& options, const Checkpoint& checkpoint, const Progress& progress);

}  // namespace shadefit
