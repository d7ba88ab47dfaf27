#include "reports/io/files.hpp"

#include <system_error>

#include "fit/input/bounded_file.hpp"

namespace shadefit {
namespace fs = std::filesystem;

std::string quoted_path(const fs::path& path) {
  return "'" + path.string() + "'";
}

fs::path without_detours(const fs::path& directory) {
  fs::path shorter;
  for (const fs::path& part : directory) {
    std::error_code ignored;
    const bool is_nothing = !shorter.empty() && (part.empty() || part == ".");
    const bool is_detour = !shorter.empty() && part == ".." &&
                           fs::symlink_status(shorter, ignored).type() == fs::file_type::not_found;
    if (is_detour) {
      shorter = shorter.parent_path();
    } else if (!is_nothing) {
      shorter /= part;
    }
  }
  return shorter.empty() && !directory.empty() ? "." : shorter;
}

std::string read_file(const fs::path& path) {
  return read_bounded(path, most_file_bytes);
}

}  // namespace shadefit
