#pragma once

#include <filesystem>
#include <string>

namespace shadefit::lint {

/// A path as shown: relative to `current`, an absolute folder, if it is absolute and below that; otherwise as
/// given. With '/' between its names, without "." and double '/'. The folder `current` itself is the empty
/// text.
inline std::string shown_name(const std::filesystem::path& path, const std::filesystem::path& current) {
  std::filesystem::path shown = path;
  if (path.is_absolute()) {
    const std::filesystem::path relative = path.lexically_relative(current);
    if (!relative.empty() && *relative.begin() != "..") shown = relative;
  }
  std::filesystem::path result;
  for (const auto& part : shown)
    if (!part.empty() && part != ".") result /= part;
  return result.generic_string();
}

}  // namespace shadefit::lint
