#include "reports/io/files.hpp"

#include <system_error>

#include "fit/support/bounded_file.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace fs = std::filesystem;

std::string quoted_path(const fs::path& path) {
  return "'" + path.string() + "'";
}

fs::path from_the_root(const fs::path& directory) {
  std::error_code error;
  fs::path path = fs::absolute(directory, error);
  if (error) {
    throw UserError("output directory " + quoted_path(directory) +
                    " is relative to a working directory that cannot be told: " + error.message());
  }
  return path;
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

void require_directory(const fs::path& directory) {
  if (directory.empty()) throw UserError("output directory '' is empty: name a directory");
  std::error_code ignored;
  const fs::path whole = from_the_root(without_detours(directory));
  for (fs::path part = whole; part != part.root_path(); part = part.parent_path()) {
    std::error_code error;
    if (fs::is_directory(part, error)) return;
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
      throw UserError("output directory " + quoted_path(directory) + " cannot be used: " + error.message());
    if (fs::exists(fs::symlink_status(part, ignored))) {
      const bool below = whole.lexically_normal() != part.lexically_normal();
      throw UserError("output directory " + quoted_path(directory) +
                      (below ? " lies below " + quoted_path(part) + ", which is not a directory"
                             : " is not a directory") +
                      ": it must be a directory, or free to become one");
    }
  }
}

std::string read_file(const fs::path& path) {
  return read_bounded(path, most_file_bytes);
}

}  // namespace shadefit
