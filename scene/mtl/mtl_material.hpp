#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "scene/materials/material.hpp"
#include "scene/mtl/mtl_lines.hpp"
#include "scene/textures/texture.hpp"

/// A material of Wavefront's format in the terms of one lobe.
namespace shadefit::scene {

/// Reads maps of one file, each once.
class MtlMapReader {
 public:
  explicit MtlMapReader(const std::filesystem::path& folder) : folder_(folder) {}

  /// The histogram of a map; where it is missing or no PNG or JPEG, every code alike, and `what` is noted in
  /// `unknowns`. Throws UserError: a damaged picture, a name outside of the folder.
  Histogram read(const ScalarMap& map, std::string_view what, std::vector<std::string>& unknowns);

 private:
  std::filesystem::path folder_;
  PictureReader pictures_;
  std::map<std::pair<std::string, Channel>, Histogram> read_;
};

/// The material as `read_mtl` says. Throws UserError naming file, line and rule.
Material mtl_material(const MtlEntry& entry, const std::string& file, MtlMapReader& reader,
                      const Conventions& conventions);

}  // namespace shadefit::scene
