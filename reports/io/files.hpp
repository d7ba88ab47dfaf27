#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

/// Files, and where they may stand.
namespace shadefit {

struct File {
  std::string name;  ///< below the directory that is written; may begin with one sub-directory, "plots/x.csv"
  std::string content;
};

/// `directory` without each "x/.." whose x is not there and so no link to elsewhere: nobody wants an empty x.
/// Any other ".." stays, because what x is decides where it leads.
std::filesystem::path without_detours(const std::filesystem::path& directory);

/// Throws UserError where `directory` cannot become one or be written to: it is a file, lies below one, is
/// relative to a working directory that is gone, or the system lets nothing be created there. What it tries
/// with is gone again, so that a long run can refuse before it starts.
void require_directory(const std::filesystem::path& directory);

/// A path as messages have it.
std::string quoted_path(const std::filesystem::path& path);

/// A path from the root. Throws UserError where it is relative to a working directory that is gone.
std::filesystem::path from_the_root(const std::filesystem::path& directory);

/// What a file may have that no kind of file gives a smaller limit: far above anything that shadefit writes.
inline constexpr std::uintmax_t most_file_bytes = 64U << 20;

/// The whole of a file of at most `most_file_bytes`. Throws UserError naming the path.
std::string read_file(const std::filesystem::path& path);

}  // namespace shadefit
