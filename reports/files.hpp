#pragma once

#include <cstdint>
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

/// `directory` without each "x/.." whose x is not there and so no link to elsewhere: nobody wants an empty x.
/// Any other ".." stays, because what x is decides where it leads.
std::filesystem::path without_detours(const std::filesystem::path& directory);

/// Throws UserError where `directory` cannot become one or be written to: it is a file, lies below one, is
/// relative to a working directory that is gone, or the system lets nothing be created there. What it tries
/// with is gone again, so that a long run can refuse before it starts.
void require_directory(const std::filesystem::path& directory);

/// Creates the directory (`without_detours`), those that names begin with, and writes all the files: each
/// beside its place first, and when all stand, renames them and removes the files named `obsolete`, keeping
/// what they replace until the last one is in place. An obsolete name that is not there, or is a directory,
/// is passed over. The checkpoint is called before each file and once more before the first is renamed; after
/// that nothing ends the work any more. Throws UserError naming the path and what went wrong. Then, and when
/// the checkpoint throws, old files are as they were and nothing new is left over. What others left under a
/// name that would be used on the way is neither written, nor taken for ours.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files,
                 const Checkpoint& checkpoint = keep_going, const std::vector<std::string>& obsolete = {});

/// What a file may have that no kind of file gives a smaller limit: far above anything that shadefit writes.
inline constexpr std::uintmax_t most_file_bytes = 64U << 20;

/// The whole of a file of at most `most_file_bytes`. Throws UserError naming the path.
std::string read_file(const std::filesystem::path& path);

}  // namespace shadefit
