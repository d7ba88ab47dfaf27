#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/io/files.hpp"

/// Writes results: no file is ever half-written, and no foreign file is touched.
namespace shadefit {

/// Throws UserError unless files can be created in the directory or, where it does not exist yet, in the
/// first directory above it that does. So long work can be refused before it starts.
void require_writable(const std::filesystem::path& directory);

/// Throws UserError if a file would replace one that shadefit did not write. A picture of ours is marked
/// (`marked_picture`). Any other file of ours begins like the new one: with the same first line, or for JSON
/// with the same first two fields.
void require_own(const std::filesystem::path& directory, const std::vector<File>& files);

/// A picture as gnuplot drew it with our name near its end.
std::string marked_picture(const std::string& svg);

/// Writes the files, and the directories that they need. Each is written beside its place, with the mode and,
/// if the system allows it, the owner of the file that it replaces, and then renamed to its place. Throws
/// UserError naming the path and what went wrong; the files before that one are written.
void write_files(const std::filesystem::path& directory, const std::vector<File>& files);

/// Removes the new files that a run was writing in the directory when it was killed: `.shadefit-PID-NUMBER`,
/// where no process has that PID any more. `write_files` does so too.
void remove_leftovers(const std::filesystem::path& directory);

/// Removes the files that exist and that shadefit wrote. Their contents are the beginnings by which they are
/// recognised.
void remove_own(const std::filesystem::path& directory, const std::vector<File>& files);

}  // namespace shadefit
