#include "reports/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <list>
#include <system_error>

#include "fit/user_error.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

/// A file that takes its place in steps: written beside it, the old one kept aside, renamed, finished. Unless
/// it comes to the last step, everything is as it was before the first.
class Replacement {
 public:
  /// Writes the new file beside the place, under a name of this process's own.
  Replacement(const fs::path& place, const std::string& content)
      : place_(place), partial_(beside("partial")), old_(beside("old")) {
    errno = 0;
    std::FILE* file =
        std::fopen(partial_.c_str(), "wbx");  // x: never through a file or link that is already there
    if (file == nullptr) fail(errno);
    const bool is_written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
    const bool is_flushed = std::fclose(file) == 0;
    if (!is_written || !is_flushed) {
      const int error = errno;
      remove(partial_);
      fail(error);
    }
  }
  ~Replacement() {
    if (!is_finished_) undo();
    if (has_old_) remove(old_);
    if (!is_placed_) remove(partial_);
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  /// Gives the old file, where there is one, a second name; where the file system has none to give, its only
  /// one.
  void keep_old() {
    std::error_code error;
    if (fs::is_directory(place_, error))
      throw UserError("cannot write " + quoted(place_) + ": it is a directory");
    if (!fs::exists(fs::symlink_status(place_, error))) return;
    fs::create_hard_link(place_, old_, error);
    if (error && error != std::errc::file_exists) {
      fs::rename(place_, old_, error);
      is_moved_ = !error;
    }
    if (error) {
      throw UserError("cannot keep the old " + quoted(place_) + " as " + quoted(old_) + ": " +
                      error.message());
    }
    has_old_ = true;
  }

  void put() {
    std::error_code error;
    fs::rename(partial_, place_, error);
    if (error) throw UserError("cannot write " + quoted(place_) + ": " + error.message());
    is_placed_ = true;
  }

  void finish() { is_finished_ = true; }

 private:
  void undo() {
    if (has_old_ && (is_moved_ || is_placed_)) {
      std::error_code ignored;  // the old file then stays under its other name
      fs::rename(old_, place_, ignored);
      has_old_ = false;
    } else if (is_placed_) {
      remove(place_);
    }
  }
  fs::path beside(const char* suffix) const {
    return place_.parent_path() / fmt::format(".{}.{}.{}", place_.filename().string(), ::getpid(), suffix);
  }
  [[noreturn]] void fail(int error) const {
    throw UserError("cannot write " + quoted(place_) + ": " + std::strerror(error != 0 ? error : EIO));
  }
  static void remove(const fs::path& path) {
    std::error_code ignored;
    fs::remove(path, ignored);
  }

  fs::path place_, partial_, old_;
  bool has_old_ = false, is_moved_ = false, is_placed_ = false, is_finished_ = false;
};

/// A directory, created with those above it that were missing; unless they are kept, those are removed again.
class Directory {
 public:
  explicit Directory(const fs::path& directory) {
    std::error_code error;
    for (fs::path part = fs::absolute(directory); !fs::exists(part, error); part = part.parent_path())
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

}  // namespace

void require_directory(const fs::path& directory) {
  if (directory.empty()) throw UserError("output directory '' is empty: name a directory");
  std::error_code ignored;
  for (fs::path part = fs::absolute(directory); part != part.root_path(); part = part.parent_path()) {
    if (fs::is_directory(part, ignored)) return;
    if (fs::exists(fs::symlink_status(part, ignored))) {
      const bool below = fs::absolute(directory).lexically_normal() != part.lexically_normal();
      throw UserError(
          "output directory " + quoted(directory) +
          (below ? " lies below " + quoted(part) + ", which is no directory" : " is no directory") +
          ": it must be a directory, or free to become one");
    }
  }
}

void write_files(const fs::path& directory, const std::vector<File>& files, const Checkpoint& checkpoint) {
  require_directory(directory);
  // Destroyed from the front: what lies within another directory, before it.
  std::list<Directory> created;
  created.emplace_front(directory);
  for (const File& file : files) created.emplace_front((directory / file.name).parent_path());
  std::list<Replacement> replacements;
  for (const File& file : files) {
    checkpoint();
    replacements.emplace_back(directory / file.name, file.content);
  }
  for (Replacement& file : replacements) file.keep_old();
  checkpoint();
  for (Replacement& file : replacements) file.put();
  for (Replacement& file : replacements) file.finish();
  for (Directory& made : created) made.keep();
}

std::string read_file(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw UserError("cannot read " + quoted(path) + ": there is no such file");
  if (error) throw UserError("cannot read " + quoted(path) + ": " + error.message());
  if (fs::is_directory(status)) throw UserError("cannot read " + quoted(path) + ": it is a directory");
  if (!fs::is_regular_file(status))
    throw UserError("cannot read " + quoted(path) + ": it is not a regular file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string content(std::istreambuf_iterator<char>(in), {});
  if (!in && !in.eof())
    throw UserError("cannot read " + quoted(path) + ": " + std::strerror(errno != 0 ? errno : EIO));
  return content;
}

}  // namespace shadefit
