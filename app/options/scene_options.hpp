#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/outcome.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/io/writers.hpp"
#include "scene/plan/plan.hpp"

namespace CLI {
class App;
}

/// The command `scene`.
namespace shadefit {

struct SceneOptions {
  std::vector<std::string> files = {};
  std::optional<double> tolerance = {};  ///< in linear values; empty: 1/255
  std::optional<double> codes = {};      ///< the tolerance in sRGB codes instead
  std::optional<int> lights = {};        ///< empty: as many as the files name, else 1
  scene::PixelPrecision precision = scene::PixelPrecision::float32;
  scene::Conventions conventions = {};    ///< how the files are read
  std::optional<Language> language = {};  ///< prints only the code in it
  std::optional<std::string> out = {};    ///< a directory; empty: print only
  bool json = false;
  bool force = false;                   ///< as in `RunOptions`
  std::vector<std::string> words = {};  ///< of the command that prints the code, without files and --lang
  Terminal terminal = {};
};

/// Declares its options.
void declare_scene(CLI::App& scene, SceneOptions& options);

/// Reads the scene and plans its shading. Exit 1 if the plan exceeds the tolerance.
Outcome scene_command(const SceneOptions& options, const Checkpoint& checkpoint);

}  // namespace shadefit
