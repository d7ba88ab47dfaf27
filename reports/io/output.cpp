#include "reports/io/output.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <list>
#include <string_view>
#include <system_error>

#include "fit/support/user_error.hpp"
#include "reports/io/own_file.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to(const char* act, const fs::path& place, const std::string& words) {
  throw UserError(fmt::format("cannot {} {}: {}", act, quoted_path(place), words));
}

/// The name of a place in the working directory is shown as given, without "./".
fs::path place_of(const fs::path& directory, const File& file) {
  return directory == "." ? fs::path(file.name) : directory / file.name;
}

/// A file beside its place. It is removed unless it is put there.
class NewFile : boost::noncopyable {
 public:
  NewFile(const fs::path& place, std::size_t number)
      : place_(place), path_(place.parent_path() / fmt::format(".shadefit-{}-{}", ::getpid(), number)) {}
  ~NewFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

  void write(std::string_view content) const {
    std::FILE* stream = std::fopen(path_.c_str(), "wbx");
    if (stream == nullptr) fail_to("write", place_, std::strerror(errno));
    const bool is_written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
    const int write_error = errno;
    struct stat old {};
    if (::stat(place_.c_str(), &old) == 0 && S_ISREG(old.st_mode)) {
      // Only root may change an owner. The mode comes last, because a new owner clears some of its bits.
      if (::fchown(::fileno(stream), old.st_uid, old.st_gid) != 0) errno = 0;
      ::fchmod(::fileno(stream), old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
    }
    const bool is_closed = std::fclose(stream) == 0;
    if (!is_written || !is_closed) fail_to("write", place_, std::strerror(is_written ? errno : write_error));
  }

  void put() const {
    std::error_code error;
    fs::rename(path_, place_, error);
    if (error) fail_to("write", place_, error.message());
  }

 private:
  fs::path place_, path_;
};

}  // namespace

void require_writable(const fs::path& directory) {
  if (directory.empty()) throw UserError("output directory '' is empty: name a directory");
  std::error_code error;
  const fs::path whole = fs::absolute(without_detours(directory), error);
  if (error) {
    throw UserError(
        fmt::format("output directory {} is relative to a working directory that cannot be told: {}",
                    quoted_path(directory), error.message()));
  }
  fs::path part = whole;
  fs::file_status status = fs::symlink_status(part, error);
  while (status.type() == fs::file_type::not_found) {
    part = part.parent_path();
    status = fs::symlink_status(part, error);
  }
  if (!fs::status_known(status)) fail_to("create directory", directory, error.message());
  const bool is_there = part == whole;
  if (!fs::is_directory(part, error)) {
    throw UserError(fmt::format(
        "output directory {} {}: it must be a directory, or free to become one", quoted_path(directory),
        is_there ? "is not a directory" : "lies below " + quoted_path(part) + ", which is not a directory"));
  }
  std::string trial = (part / ".shadefit-XXXXXX").string();
  if (::mkdtemp(trial.data()) == nullptr)
    fail_to(is_there ? "write to" : "create directory", without_detours(directory), std::strerror(errno));
  ::rmdir(trial.c_str());
}

void require_own(const fs::path& directory, const std::vector<File>& files) {
  for (const File& file : files) {
    const fs::path place = place_of(without_detours(directory), file);
    std::error_code error;
    if (!fs::exists(fs::symlink_status(place, error)) || is_own(place, file)) continue;
    const bool is_empty = fs::is_regular_file(place, error) && fs::file_size(place, error) == 0;
    if (!is_empty && !fs::is_directory(place, error))
      throw UserError(quoted_path(place) +
                      " was not written by shadefit: move it away, or replace it with --force");
  }
}

void write_files(const fs::path& named, const std::vector<File>& files) {
  require_writable(named);
  const fs::path directory = without_detours(named);
  std::list<NewFile> written;
  for (const File& file : files) {
    const fs::path place = place_of(directory, file), folder = (directory / file.name).parent_path();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail_to("create directory", folder, error.message());
    if (written.empty()) remove_leftovers(folder);
    if (fs::is_directory(place, error)) fail_to("write", place, "it is a directory");
    written.emplace_back(place, written.size()).write(file.content);
  }
  for (const NewFile& file : written) file.put();
}

void remove_leftovers(const fs::path& directory) {
  std::error_code error, ignored;
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    int process = 0, number = 0, length = 0;
    const bool is_ours = std::sscanf(name.c_str(), ".shadefit-%d-%d%n", &process, &number, &length) == 2 &&
                         length == std::ssize(name) && process > 0 && entry->is_regular_file(ignored);
    // In a container the killed process often had the number of this one.
    if (is_ours && (process == ::getpid() || (::kill(process, 0) != 0 && errno == ESRCH)))
      fs::remove(entry->path(), ignored);
  }
}

void remove_own(const fs::path& directory, const std::vector<File>& files) {
  for (const File& file : files) {
    const fs::path place = place_of(without_detours(directory), file);
    std::error_code error;
    if (is_own(place, file) && !fs::remove(place, error)) fail_to("remove", place, error.message());
  }
}

}  // namespace shadefit
