#include "scene/mtl/read_mtl.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <sstream>

#include "fit/support/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "scene/files/limits.hpp"
#include "scene/files/uri.hpp"
#include "scene/files/words.hpp"
#include "scene/mtl/mtl_material.hpp"

namespace shadefit::scene {
namespace {

/// The channel that the option -imfchan of a map names. Anything but a colour is taken for grey, where all
/// agree.
ScalarMap scalar_map(const std::string& name, const tinyobj::texture_option_t& options) {
  const Channel channel = options.imfchan == 'g'   ? Channel::green
                          : options.imfchan == 'b' ? Channel::blue
                                                   : Channel::red;
  return {name, channel};
}

MtlMaps maps_of(const tinyobj::material_t& material) {
  return {scalar_map(material.specular_highlight_texname, material.specular_highlight_texopt),
          scalar_map(material.ambient_texname, material.ambient_texopt),
          scalar_map(material.roughness_texname, material.roughness_texopt),
          scalar_map(material.metallic_texname, material.metallic_texopt),
          !material.specular_texname.empty(),
          !material.diffuse_texname.empty()};
}

}  // namespace

Scene read_mtl(const std::filesystem::path& file, const Conventions& conventions) {
  return read_mtl(read_bounded(file, most_mtl_bytes), file, conventions);
}

Scene read_mtl(std::string_view content, const std::filesystem::path& file, const Conventions& conventions) {
  const std::string_view text = without_mark(content);
  const std::vector<MtlNumbers> numbers = checked_lines(text, file.string(), most_materials);
  Scene scene;
  if (numbers.empty()) return scene;  // the loader would make one without a name
  std::map<std::string, int> ignored;
  std::vector<tinyobj::material_t> loaded;
  std::istringstream stream{std::string(text)};
  std::string warnings, errors;
  tinyobj::LoadMtl(&ignored, &loaded, &stream, &warnings, &errors);
  if (loaded.size() != numbers.size()) {
    throw UserError(fmt::format("'{}': {} materials begin in it, of which {} can be read", file.string(),
                                numbers.size(), loaded.size()));
  }
  MtlMapReader reader(folder_of(file));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    scene.materials.push_back(
        mtl_material(numbers[i], maps_of(loaded[i]), file.string(), reader, conventions));
  return scene;
}

}  // namespace shadefit::scene
