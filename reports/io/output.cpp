#include "reports/io/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <list>
#include <optional>
#include <string_view>
#include <system_error>

#include "fit/support/user_error.hpp"
#include "reports/io/own_file.hpp"

namespace shadefit {
namespace output_parts {

namespace fs = std::filesystem;

inline std::string words_of(int error) {
  return std::strerror(error != 0 ? error : EIO);
}

[[noreturn]] inline void fail_to(const char* act, const fs::path& place, const std::string& words) {
  throw UserError(fmt::format("cannot {} {}: {}", act, quoted_path(place), words));
}

/// A directory, created together with missing directories above it. Unless they are kept, they are removed
/// again.
class Directory : boost::noncopyable {
 public:
  explicit Directory(const fs::path& directory) {
    std::error_code error;
    for (fs::path part = from_the_root(directory); !fs::exists(part, error); part = part.parent_path())
      created_.push_back(part);
    fs::create_directories(directory, error);
    if (error) {
      remove();
      throw UserError("cannot create directory " + quoted_path(directory) + ": " + error.message());
    }
  }
  ~Directory() { remove(); }

  void keep() { created_.clear(); }

 private:
  void remove() const {
    std::error_code ignored;  // directories with foreign files stay
    for (const fs::path& part : created_) fs::remove(part, ignored);
  }

  std::vector<fs::path> created_;  ///< the innermost first
};

/// A lock on a directory, released with the process at the latest. Without support by the file system it
/// locks nothing.
class Lock : boost::noncopyable {
 public:
  explicit Lock(const fs::path& directory)
      : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(descriptor_);
    throw UserError("output directory " + quoted_path(directory) +
                    " is in use by another run: wait for its end, or name another");
  }
  ~Lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  int descriptor_;
};

inline std::vector<fs::path> paths_in(const fs::path& directory) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    paths.push_back(entry->path());
  return paths;
}

constexpr std::string_view workshop_prefix = ".shadefit-", unique_part = "XXXXXX";

inline bool is_workshop_name(std::string_view name) {
  return name.starts_with(workshop_prefix) && name.size() == workshop_prefix.size() + unique_part.size();
}

/// "12.new" or "12.old".
inline bool is_change_name(std::string_view name) {
  const std::size_t point = name.find_first_not_of("0123456789");
  return point > 0 && point < name.size() && (name.substr(point) == ".new" || name.substr(point) == ".old");
}

/// A new directory inside another, so that what is written there can be renamed to its place. Its name is
/// unique, so no foreign file is in the way. Removed at the end, unless it contains a foreign file. It is
/// locked until then: one without a lock is that of a run that was killed.
class Workshop : boost::noncopyable {
 public:
  explicit Workshop(const fs::path& directory) {
    remove_leftovers(directory);
    std::error_code none;
    do {
      close();
      std::string name = (directory / fmt::format("{}{}", workshop_prefix, unique_part)).string();
      if (::mkdtemp(name.data()) == nullptr) fail_to("write to", directory, words_of(errno));
      path_ = name;
      descriptor_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
    } while (!fs::exists(path_, none));  // another run may have removed it before the lock
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove(path_, ignored);
    close();
  }

  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  void close() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  fs::path path_;
  int descriptor_ = -1;
};

/// Writes or removes one file. The old file is restored unless the change is finished.
class FileChange : boost::noncopyable {
 public:
  /// `fresh` is the new file, empty where the place is to be empty; the old one is kept as `kept`.
  FileChange(fs::path place, fs::path fresh, fs::path kept)
      : place_(std::move(place)), fresh_(std::move(fresh)), kept_(std::move(kept)) {}
  ~FileChange() {
    std::error_code ignored;
    if (!is_finished_) undo();
    if (!fresh_.empty()) fs::remove(fresh_, ignored);
    if (has_kept_) fs::remove(kept_, ignored);
  }

  /// Writes the new file, with the mode and the owner of the old one.
  void write(std::string_view content) {
    errno = 0;
    std::FILE* stream = std::fopen(fresh_.c_str(), "wbx");
    if (stream == nullptr) fail_to("write", place_, words_of(errno));
    const bool is_written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
    const int write_error = errno;
    struct stat old {};
    if (::stat(place_.c_str(), &old) == 0 && S_ISREG(old.st_mode)) {
      // Only root may change an owner. The mode comes last, because a new owner clears some of its bits.
      if (::fchown(::fileno(stream), old.st_uid, old.st_gid) != 0) errno = 0;
      ::fchmod(::fileno(stream), old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
    }
    errno = 0;
    const bool is_flushed = std::fclose(stream) == 0;
    if (!is_written || !is_flushed) fail_to("write", place_, words_of(is_written ? errno : write_error));
  }

  void put() {
    keep_old();
    std::error_code error;
    if (!fresh_.empty()) {
      fs::rename(fresh_, place_, error);
    } else {
      fs::remove(place_, error);
    }
    if (error) fail_to(act(), place_, error.message());
    is_put_ = true;
  }

  void finish() { is_finished_ = true; }

 private:
  const char* act() const { return fresh_.empty() ? "remove" : "write"; }

  /// Gives the old file a second name, so that its place is never empty. If the file system has no second
  /// names, copies or moves it.
  void keep_old() {
    std::error_code error;
    const auto status = fs::symlink_status(place_, error);
    if (!fs::exists(status)) return;
    if (fs::is_directory(status)) fail_to(act(), place_, "it is a directory");
    fs::create_hard_link(place_, kept_, error);
    if (error) fs::copy(place_, kept_, fs::copy_options::copy_symlinks, error);
    if (error) fs::rename(place_, kept_, error);  // one that only its owner may read
    if (error) fail_to("keep the old", place_, error.message());
    has_kept_ = true;
  }
  void undo() {
    std::error_code error;
    if (has_kept_) {
      fs::rename(kept_, place_, error);
      // rename keeps two names of one file; an old file that cannot go back stays at `kept`
      has_kept_ = !error;
    } else if (is_put_) {
      fs::remove(place_, error);
    }
  }

  fs::path place_, fresh_, kept_;
  bool has_kept_ = false, is_put_ = false, is_finished_ = false;
};

/// Refuses to overwrite an existing file, unless it is ours.
inline void require_free(const fs::path& place, const File& file, Foreign foreign) {
  std::error_code error;
  const auto status = fs::symlink_status(place, error);
  if (error && status.type() != fs::file_type::not_found) fail_to("write", place, error.message());
  if (!fs::exists(status)) return;
  if (fs::is_directory(status)) fail_to("write", place, "it is a directory");
  if (foreign == Foreign::replaced || is_own(place, file)) return;
  const bool is_empty = fs::is_regular_file(place, error) && fs::file_size(place, error) == 0;
  if (!is_empty)
    throw UserError(
        quoted_path(place) +
        " was not written by shadefit, or was changed since: move it away, or replace it with --force");
}

}  // namespace output_parts

using namespace output_parts;

// Destroyed in reverse order: first the changes, then the workshop that contains them, then the created
// directories.
struct Output::Parts {
  fs::path directory;
  std::list<Directory> created;
  std::optional<Lock> lock;
  std::optional<Workshop> workshop;
  std::list<FileChange> changes;
};

void remove_leftovers(const fs::path& directory) {
  std::error_code error;
  for (const fs::path& path : paths_in(directory)) {
    if (!is_workshop_name(path.filename().string())) continue;
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
      for (const fs::path& file : paths_in(path))
        if (is_change_name(file.filename().string())) fs::remove(file, error);
      fs::remove(path, error);  // unless a foreign file is in it
    }
    ::close(descriptor);
  }
}

Output::Output(const fs::path& named, Company company) : parts_(std::make_unique<Parts>()) {
  require_directory(named);
  parts_->directory = without_detours(named);
  parts_->created.emplace_front(parts_->directory);
  if (company == Company::refused) parts_->lock.emplace(parts_->directory);
  const Workshop trial(parts_->directory);
}

Output::~Output() = default;

void Output::prepare(const std::vector<File>& files, const std::vector<File>& obsolete, Foreign foreign,
                     const Checkpoint& checkpoint) {
  Parts& parts = *parts_;
  // The name of a place in the working directory is shown as given, without "./".
  const auto place_of = [&](const File& file) {
    return parts.directory == "." ? fs::path(file.name) : parts.directory / file.name;
  };
  for (const File& file : files) require_free(place_of(file), file, foreign);
  // The contents of a directory are removed before the directory.
  for (const File& file : files) parts.created.emplace_front((parts.directory / file.name).parent_path());
  const Workshop& workshop = parts.workshop.emplace(parts.directory);
  const auto change = [&](const fs::path& place, bool is_new) -> FileChange& {
    const std::string number = std::to_string(parts.changes.size());
    return parts.changes.emplace_back(place, is_new ? workshop / (number + ".new") : fs::path(),
                                      workshop / (number + ".old"));
  };
  for (const File& file : files) {
    checkpoint();
    change(place_of(file), true).write(file.content);
  }
  for (const File& file : obsolete) {
    if (is_own(place_of(file), file)) change(place_of(file), false);
  }
  checkpoint();
}

void Output::put() {
  for (FileChange& change : parts_->changes) change.put();
  for (FileChange& change : parts_->changes) change.finish();
  for (Directory& made : parts_->created) made.keep();
  parts_->changes.clear();
  parts_->workshop.reset();
  parts_->lock.reset();
}

void write_files(const fs::path& directory, const std::vector<File>& files, const Checkpoint& checkpoint,
                 const std::vector<File>& obsolete) {
  Output output(directory);
  output.prepare(files, obsolete, Foreign::replaced, checkpoint);
  output.put();
}

}  // namespace shadefit
