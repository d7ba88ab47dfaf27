#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// The type of a file by its extension.
namespace shadefit::scene {

/// Whether the name ends with an extension such as ".glb", ignoring case.
inline bool has_extension(const std::filesystem::path& file, std::string_view small_letters) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension == small_letters;
}

}  // namespace shadefit::scene
