#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

/// Files and directories for output.
namespace shadefit {

struct File {
  std::string name;  ///< below the directory that is written; may begin with one sub-directory, "plots/x.csv"
  std::string content;
};

/// `directory` without each "x/.." whose x does not exist, so that no empty x is created. Any other ".."
/// stays, because x may be a link.
std::filesystem::path without_detours(const std::filesystem::path& directory);

/// A path as in messages.
std::string quoted_path(const std::filesystem::path& path);

/// The size limit of files without a smaller limit of their own: far above anything that shadefit writes.
inline constexpr std::uintmax_t most_file_bytes = 64U << 20;

/// The whole of a file of at most `most_file_bytes`. Throws UserError naming the path.
std::string read_file(const std::filesystem::path& path);

}  // namespace shadefit
