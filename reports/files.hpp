#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fit/checkpoint.hpp"

/// Writing results so that nothing is ever half-written.
namespace shadefit {

struct File {
  std::string name;  ///< below the directory that is written; may begin with one sub-directory, "plots/x.csv"
  std::string content;
};

/// Throws UserError where `directory` cannot become one: it is a file, or lies below one. Creates nothing, so
/// that a long run can refuse before it starts.
void require_directory(const std::filesystem::path& directory);

/// Creates the directory, those that names begin with, and writes all the files: each beside its place first,
/// and when all stand, renames them, keeping what they replace until the last one is in place. The checkpoint
/// is called before each file and once more before the first is renamed; after that nothing ends the work any
/// more. Throws UserError naming the path and what went wrong. Then, and when the checkpoint throws, old
/// files are as they were and nothing new is left over.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files,
                 const Checkpoint& checkpoint = keep_going);

/// The whole of a file. Throws UserError naming the path.
std::string read_file(const std::filesystem::path& path);

}  // namespace shadefit
