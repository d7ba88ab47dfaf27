#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "fit/input/bounded_file.hpp"

namespace shadefit {

/// A file to write.
struct File {
  std::string name;  ///< below the directory that is written; may begin with one sub-directory, "plots/x.csv"
  std::string content;
};

/// The size limit of files without a smaller limit of their own: far above anything that shadefit writes.
inline constexpr std::uintmax_t most_file_bytes = 64U << 20;

/// The whole of a file of at most `most_file_bytes`. Throws UserError naming the path.
inline std::string read_file(const std::filesystem::path& path) {
  return read_bounded(path, most_file_bytes);
}

}  // namespace shadefit
