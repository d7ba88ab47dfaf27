#include "scene/gltf/read_mtl.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <functional>
#include <limits>
#include <set>

#include "fit/input/bounded_file.hpp"
#include "fit/support/lines.hpp"
#include "fit/support/user_error.hpp"
#include "scene/gltf/mtl_material.hpp"
#include "scene/materials/messages.hpp"
#include "scene/materials/uri.hpp"

namespace shadefit::scene {
namespace {

/// Geometry lines may have any length; lines longer than this do not name libraries.
constexpr std::size_t most_line_bytes = 4096;

/// The names of each distinct mtllib line are looked up in the file system; no exporter writes this many.
constexpr std::size_t most_library_lines = 1000;

/// The libraries of one mtllib line: the whole text if that is a file, because names may have blanks; else
/// its words.
std::vector<std::string> libraries_on_line(std::string_view values, const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto is_file = [&](std::string_view name) {
    return std::filesystem::exists(path_within(folder, name), ignored);
  };
  if (is_file(values)) return {std::string(values)};
  std::vector<std::string> names;
  for (Words words = words_of_line(values); !words.key.empty(); words = words_of_line(words.values))
    names.emplace_back(words.key);
  return names;
}

/// Calls `on_line` with the number and the text of each line; long lines are cut.
template <class OnLine>
void read_lines(const std::filesystem::path& file, const OnLine& on_line) {
  require_size(file, most_obj_bytes);
  std::ifstream in(file, std::ios::binary);
  std::array<char, most_line_bytes> line;
  for (std::size_t number = 1; in.getline(line.data(), line.size()) || in.gcount() > 0; ++number) {
    on_line(number, std::string_view(line.data()));
    if (!in.fail() || in.eof()) continue;
    in.clear();
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
}

}  // namespace

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

Scene read_obj(const std::filesystem::path& file, const Conventions& conventions) {
  Scene scene;
  std::vector<Material> materials;
  std::set<std::filesystem::path> read;
  std::set<std::string, std::less<>> lines;
  std::set<std::string> used;  // a file without a line usemtl is a list of libraries: all count as used
  const std::filesystem::path folder = folder_of(file);
  read_lines(file, [&](std::size_t number, std::string_view line) {
    std::string_view text = without_mark(line);
    const Words words = words_of_line(next_line(text));
    if (words.key == "usemtl" && used.size() <= most_materials) used.insert(shortened(words.values));
    if (words.key != "mtllib" || !lines.emplace(words.values).second) return;
    at_place(fmt::format("'{}', line {}", file.string(), number), [&] {
      if (lines.size() > most_library_lines)
        throw UserError(fmt::format("there are more than {} lines mtllib", most_library_lines));
      for (const std::string& name : libraries_on_line(words.values, folder)) {
        if (!read.insert(path_within(folder, name)).second) continue;
        for (Material& material : read_mtl(folder / name, conventions).materials) {
          if (materials.size() == most_materials)
            throw UserError(fmt::format("there are more than {} materials", most_materials));
          materials.push_back(std::move(material));
        }
      }
    });
  });
  for (Material& material : materials) {
    if (used.empty() || used.contains(material.name) || used.size() > most_materials) {
      scene.materials.push_back(std::move(material));
    } else {
      scene.unused.push_back(std::move(material.name));
    }
  }
  return scene;
}

}  // namespace shadefit::scene
