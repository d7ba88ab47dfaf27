#include "reports/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <list>
#include <optional>
#include <string_view>
#include <system_error>

#include "fit/bounded_file.hpp"
#include "fit/user_error.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

/// Names beside `place` that this process may use until it ends: ".NAME.PID.SUFFIX", then with a counter. A
/// killed run leaves such a file, and in a container the next one has the same PID each time.
class NamesBeside {
 public:
  NamesBeside(const fs::path& place, const char* suffix) : place_(place), suffix_(suffix) {}

  fs::path next() {
    const std::string counter = tried_++ == 0 ? "" : fmt::format("{}.", tried_ - 1);
    return place_.parent_path() /
           fmt::format(".{}.{}.{}{}", place_.filename().string(), ::getpid(), counter, suffix_);
  }
  /// Against a search without end where a file system says of every name that it is taken.
  bool is_exhausted() const { return tried_ >= 1000; }

 private:
  fs::path place_;
  const char* suffix_;
  int tried_ = 0;
};

/// A new file beside `place`, never through a file or link that is already there, and the name that it has
/// or, where errno says why there is none, should have had.
struct NewFile {
  std::FILE* stream;
  fs::path path;

  NewFile(const fs::path& place, const char* suffix) {
    NamesBeside names(place, suffix);
    do {
      path = names.next();
      errno = 0;
      stream = std::fopen(path.c_str(), "wbx");
    } while (stream == nullptr && errno == EEXIST && !names.is_exhausted());
  }
};

/// A place that gets a file, or loses it, in steps: the new file written beside it, the old one kept aside,
/// put, finished. Unless it comes to the last step, everything is as it was before the first.
class FileChange {
 public:
  /// Writes the new file beside the place, under a name of this process's own; without content the place is
  /// to be empty.
  FileChange(const fs::path& place, const std::optional<std::string_view>& content) : place_(place) {
    if (!content) return;
    const NewFile file(place, "partial");
    const int error = errno;
    partial_ = file.path;
    if (file.stream == nullptr) fail("cannot create " + quoted(file.path) + ": " + words_of(error));
    const bool is_written = std::fwrite(content->data(), 1, content->size(), file.stream) == content->size();
    const int write_error = errno;
    const bool is_flushed = std::fclose(file.stream) == 0;
    if (!is_written || !is_flushed) {
      const std::string words = words_of(is_written ? errno : write_error);
      remove_quietly(*partial_);
      fail(words);
    }
  }
  ~FileChange() {
    if (!is_finished_) undo();
    if (old_) remove_quietly(*old_);
    if (!is_put_ && partial_) remove_quietly(*partial_);
  }
  FileChange(const FileChange&) = delete;
  FileChange& operator=(const FileChange&) = delete;

  /// Gives the old file, where there is one, a second name; where the file system has none to give, its only
  /// one.
  void keep_old() {
    std::error_code error;
    if (fs::is_directory(place_, error)) {
      if (partial_) fail("it is a directory");
      return;
    }
    if (!fs::exists(fs::symlink_status(place_, error))) return;
    NamesBeside names(place_, "old");
    fs::path name;
    do {
      name = names.next();
      fs::create_hard_link(place_, name, error);
    } while (error == std::errc::file_exists && !names.is_exhausted());
    if (error && error != std::errc::file_exists) name = move_aside(error);
    if (error) {
      throw UserError("cannot keep the old " + quoted(place_) + " as " + quoted(name) + ": " +
                      error.message());
    }
    old_ = name;
  }

  void put() {
    std::error_code error;
    if (partial_) {
      fs::rename(*partial_, place_, error);
    } else if (old_ && !is_moved_) {
      fs::remove(place_, error);
    }
    if (error) fail(error.message());
    is_put_ = true;
  }

  void finish() { is_finished_ = true; }

 private:
  void undo() {
    if (old_ && (is_moved_ || is_put_)) {
      std::error_code ignored;  // the old file then stays under its other name
      fs::rename(*old_, place_, ignored);
      old_.reset();
    } else if (is_put_ && partial_) {
      remove_quietly(place_);
    }
  }
  /// Renames the old file over an empty one of ours, because renaming asks nobody whose file it replaces.
  fs::path move_aside(std::error_code& error) {
    const NewFile reserved(place_, "old");
    error.assign(errno, std::generic_category());
    if (reserved.stream == nullptr) return reserved.path;
    std::fclose(reserved.stream);
    fs::rename(place_, reserved.path, error);
    if (error) remove_quietly(reserved.path);
    is_moved_ = !error;
    return reserved.path;
  }
  static std::string words_of(int error) { return std::strerror(error != 0 ? error : EIO); }
  [[noreturn]] void fail(const std::string& words) const {
    throw UserError(fmt::format("cannot {} {}: {}", partial_ ? "write" : "remove", quoted(place_), words));
  }

  fs::path place_;
  std::optional<fs::path> partial_, old_;
  bool is_moved_ = false, is_put_ = false, is_finished_ = false;
};

/// A path from the root, for which a relative one needs the working directory, and that may have been
/// removed.
fs::path from_the_root(const fs::path& directory) {
  std::error_code error;
  fs::path path = fs::absolute(directory, error);
  if (error) {
    throw UserError("output directory " + quoted(directory) +
                    " is relative to a working directory that cannot be told: " + error.message());
  }
  return path;
}

/// A directory, created with those above it that were missing; unless they are kept, those are removed again.
class Directory {
 public:
  explicit Directory(const fs::path& directory) {
    std::error_code error;
    for (fs::path part = from_the_root(directory); !fs::exists(part, error); part = part.parent_path())
      created_.push_back(part);
    fs::create_directories(directory, error);
    if (error) {
      remove();
      throw UserError("cannot create directory " + quoted(directory) + ": " + error.message());
    }
  }
  ~Directory() { remove(); }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  void keep() { created_.clear(); }

 private:
  void remove() const {
    std::error_code ignored;  // what holds files of others stays
    for (const fs::path& part : created_) fs::remove(part, ignored);
  }

  std::vector<fs::path> created_;  ///< the innermost first
};

/// Tries in a directory that is there what writing below it will need, and leaves nothing: a new directory of
/// this name. Where a user may write is known to the system alone, of a disk that is mounted without writing
/// or one that its user may not write to.
void require_writable(const fs::path& directory, const fs::path& place) {
  std::error_code error;
  NamesBeside names(place / "x", "probe");
  fs::path probe;
  do {
    probe = names.next();
  } while (!fs::create_directory(probe, error) && !error && !names.is_exhausted());
  if (error) {
    throw UserError("output directory " + quoted(directory) + " cannot be written to: " + error.message());
  }
  remove_quietly(probe);
}

}  // namespace

fs::path without_detours(const fs::path& directory) {
  fs::path shorter;
  for (const fs::path& part : directory) {
    std::error_code ignored;
    const bool is_nothing = !shorter.empty() && (part.empty() || part == ".");
    const bool is_detour = !shorter.empty() && part == ".." &&
                           fs::symlink_status(shorter, ignored).type() == fs::file_type::not_found;
    if (is_detour) {
      shorter = shorter.parent_path();
    } else if (!is_nothing) {
      shorter /= part;
    }
  }
  return shorter.empty() && !directory.empty() ? "." : shorter;
}

void require_directory(const fs::path& directory) {
  if (directory.empty()) throw UserError("output directory '' is empty: name a directory");
  std::error_code ignored;
  const fs::path whole = from_the_root(without_detours(directory));
  for (fs::path part = whole; part != part.root_path(); part = part.parent_path()) {
    std::error_code error;
    if (fs::is_directory(part, error)) return require_writable(directory, part);
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
      throw UserError("output directory " + quoted(directory) + " cannot be used: " + error.message());
    if (fs::exists(fs::symlink_status(part, ignored))) {
      const bool below = whole.lexically_normal() != part.lexically_normal();
      throw UserError(
          "output directory " + quoted(directory) +
          (below ? " lies below " + quoted(part) + ", which is no directory" : " is no directory") +
          ": it must be a directory, or free to become one");
    }
  }
}

void write_files(const fs::path& named, const std::vector<File>& files, const Checkpoint& checkpoint,
                 const std::vector<std::string>& obsolete) {
  require_directory(named);
  const fs::path directory = without_detours(named);
  // Destroyed from the front: what lies within another directory, before it.
  std::list<Directory> created;
  created.emplace_front(directory);
  for (const File& file : files) created.emplace_front((directory / file.name).parent_path());
  std::list<FileChange> changes;
  for (const File& file : files) {
    checkpoint();
    changes.emplace_back(directory / file.name, file.content);
  }
  for (const std::string& name : obsolete) changes.emplace_back(directory / name, std::nullopt);
  for (FileChange& change : changes) change.keep_old();
  checkpoint();
  for (FileChange& change : changes) change.put();
  for (FileChange& change : changes) change.finish();
  for (Directory& made : created) made.keep();
}

std::string read_file(const fs::path& path) {
  return read_bounded(path, most_file_bytes);
}

}  // namespace shadefit
