#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Writing results so that nothing is ever half-written.
namespace shadefit {

struct File {
  std::string name;
  std::string content;
};

/// Throws UserError where `directory` cannot become one: it is a file, or lies below one. Creates nothing, so
/// that a long run can refuse before it starts.
void require_directory(const std::filesystem::path& directory);

/// Creates the directory and writes all the files: each beside its place first, and when all stand, renames
/// them. Throws UserError naming the path and what went wrong; old files are then as they were and no new one
/// is left over.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files);

/// The whole of a file. Throws UserError naming the path.
std::string read_file(const std::filesystem::path& path);

}  // namespace shadefit
