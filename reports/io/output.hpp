#pragma once

#include <filesystem>
#include <vector>

#include "reports/io/files.hpp"

/// Writes results: no file is ever half-written, and no foreign file is touched.
namespace shadefit {

/// Throws UserError unless files can be created in the directory or, where it does not exist yet, in the
/// first directory above it that does. So long work can be refused before it starts.
void require_writable(const std::filesystem::path& directory);

/// Throws UserError if a file would replace one that shadefit did not write (not `is_own`).
void require_own(const std::filesystem::path& directory, const std::vector<File>& files);

/// Writes the files, and the directories that they need. Each is written beside its place, with the mode and,
/// if the system allows it, the owner of the file that it replaces. When all of them are written, they are
/// renamed to their places. Throws UserError naming the path and what went wrong. Unless the system refuses
/// to rename one, all files are written or none.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files);

/// Removes the new files that a run was writing in the directory when it was killed: `.shadefit-PID-NUMBER`,
/// where no process has that PID any more. `write_files` does so too.
void remove_leftovers(const std::filesystem::path& directory);

/// Removes the files that exist and that shadefit wrote. Their contents are the beginnings by which they are
/// recognised.
void remove_own(const std::filesystem::path& directory, const std::vector<File>& files);

}  // namespace shadefit
