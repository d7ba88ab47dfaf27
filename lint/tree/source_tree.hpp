#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lint/tree/source_language.hpp"

/// Finds and reads the source files of other projects.
namespace shadefit::lint {

/// About 100 000 lines. Larger files are data, or were generated.
inline constexpr std::uintmax_t largest_source = 4 << 20;

struct SourceFile {
  std::filesystem::path path;  ///< to open it from the current folder
  std::string
      name;  ///< as shown: PATH as given, or relative to the current folder if below it; '/' between folders
  SourceLanguage language;
};

/// What was not read, by reason.
struct SkippedFiles {
  std::size_t unknown_language = 0, binary = 0, too_large = 0;
  std::size_t vendored = 0;  ///< folders with everything below
  std::size_t minified = 0;
  std::size_t ignored = 0;  ///< source files, and folders with everything below
  std::size_t unreadable = 0;
  std::size_t links = 0;              ///< symbolic links
  std::size_t in_tables = 0;          ///< places inside tables of numbers
  std::vector<std::string> messages;  ///< one for each unreadable place, and for the first that are too large
};

/// Adds what another thread skipped. Adding in the order of files gives the messages in one order.
void add(SkippedFiles& sum, const SkippedFiles& part);

struct SourceTree {
  std::vector<SourceFile> files;  ///< by rising name, byte by byte; each file once
  SkippedFiles skipped;
};

/// Globs, and the folder that they are relative to; empty: the current one. As in .gitignore, a glob without
/// a '/' inside matches the last name of a path, and '**' any folders. Otherwise it is that of fnmatch(3).
struct FolderGlobs {
  std::filesystem::path folder;
  std::vector<std::string> globs = {};
};

struct TreeOptions {
  std::vector<std::string> exclude = {};       ///< see `FolderGlobs`, relative to the current folder
  std::vector<SourceLanguage> languages = {};  ///< empty: all
  FolderGlobs configured = {};                 ///< those of a configuration
};

/// The source files that the paths name, or that are below the folders that they name. In a work tree of git
/// these are the files that git_files() lists; for a named folder that git ignores, for one without git, and
/// where git refuses, which a message says, all files but those in a folder `build`. Left out are: what
/// globs match; folders with code of others, such as third_party; .git; symbolic links; files larger than
/// `largest_source`. A path that is named is read anyway. A named link is read as its target. If the folder
/// of globs is not above a path, that path replaces it. Throws UserError for a path that does not exist,
/// cannot be read, or is a file larger than `largest_source`; what cannot be read below a path is counted.
SourceTree find_sources(const std::vector<std::string>& paths, const TreeOptions& options);

/// All bytes of a file, which need not be UTF-8. Empty, and counted in `skipped`, if it is unreadable, binary
/// (a byte 0 in its first 8 KiB), or minified (8 KiB or more, in lines of 1000 bytes on average). Threads may
/// read at the same time, each with its own `skipped`.
std::optional<std::string> read_source(const SourceFile& file, SkippedFiles& skipped);

}  // namespace shadefit::lint
