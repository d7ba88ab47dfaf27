#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "scene/gltf/mtl_lines.hpp"
#include "scene/materials/material.hpp"
#include "scene/materials/texture.hpp"

/// Converts a material of Wavefront's format to one lobe.
namespace shadefit::scene {

/// Reads maps of one file, each once.
class MtlMapReader {
 public:
  explicit MtlMapReader(const std::filesystem::path& folder) : folder_(folder) {}

  /// The range of a map. If it is missing or neither PNG nor JPEG, the range is that of an unknown texture
  /// and `what` is added to `unknowns`. Throws UserError for a damaged picture or a name outside the folder.
  Range read(const ScalarMap& map, std::string_view what, std::vector<std::string>& unknowns);

 private:
  std::filesystem::path folder_;
  PictureReader pictures_;
  std::map<std::pair<std::string, Channel>, Range> read_;
};

/// The material as documented at `read_mtl`. Throws UserError naming file, line and rule.
Material mtl_material(const MtlEntry& entry, const std::string& file, MtlMapReader& reader,
                      const Conventions& conventions);

}  // namespace shadefit::scene
