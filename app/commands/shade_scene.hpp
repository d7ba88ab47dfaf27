#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal/progress.hpp"
#include "fit/support/checkpoint.hpp"
#include "reports/io/files.hpp"
#include "reports/table/writers.hpp"
#include "scene/plan/plan.hpp"

namespace shadefit {

/// The messages and files of `scene --shade`.
struct ShadedScene {
  std::string out = {}, err = {};  ///< text on `err`: a plan or a drawing failed
  std::vector<File> files = {};    ///< none without a directory
  std::vector<File> missing = {};  ///< pictures that were not drawn
};

/// The files that `shade_scene` may write, each with its first bytes.
std::vector<File> files_of_shading();

/// Shades a scene with the reference, with the published constants and as planned, on the widest registers of
/// this machine; also on a graphics device if its place is given. Draws pictures if a directory `out` is
/// given.
ShadedScene shade_scene(const scene::Scene& scene, const scene::Plan& plan,
                        const std::optional<std::size_t>& device, const std::optional<std::string>& out,
                        const Terminal& terminal, const Checkpoint& checkpoint, const Progress& progress);

}  // namespace shadefit
