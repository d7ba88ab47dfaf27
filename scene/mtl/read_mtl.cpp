#include "scene/mtl/read_mtl.hpp"

#include "fit/support/bounded_file.hpp"
#include "scene/files/limits.hpp"
#include "scene/files/uri.hpp"
#include "scene/files/words.hpp"
#include "scene/mtl/mtl_material.hpp"

namespace shadefit::scene {

Scene read_mtl(const std::filesystem::path& file, const Conventions& conventions) {
  return read_mtl(read_bounded(file, most_mtl_bytes), file, conventions);
}

Scene read_mtl(std::string_view content, const std::filesystem::path& file, const Conventions& conventions) {
  Scene scene;
  MtlMapReader reader(folder_of(file));
  for (const MtlEntry& entry : parse_mtl(without_mark(content), file.string(), most_materials))
    scene.materials.push_back(mtl_material(entry, file.string(), reader, conventions));
  return scene;
}

}  // namespace shadefit::scene
