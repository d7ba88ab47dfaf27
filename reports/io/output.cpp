#include "reports/io/output.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// What tells our pictures from others.
constexpr std::string_view name_of_ours = "shadefit";

/// A path as in messages.
std::string quoted_path(const fs::path& path) {
  return "'" + path.string() + "'";
}

[[noreturn]] void fail_to(const char* act, const fs::path& place, const std::string& words) {
  throw UserError(fmt::format("cannot {} {}: {}", act, quoted_path(place), words));
}

/// The name of a place in the working directory is shown as given, without "./".
fs::path place_of(const fs::path& directory, const File& file) {
  return directory == "." ? fs::path(file.name) : directory / file.name;
}

/// Writes a file beside its place, with the mode and the owner of the one that is there, and renames it.
void write_file(const fs::path& place, std::string_view content) {
  const fs::path beside = place.parent_path() / fmt::format(".shadefit-{}-0", ::getpid());
  std::FILE* stream = std::fopen(beside.c_str(), "wbx");
  if (stream == nullptr) fail_to("write", place, std::strerror(errno));
  bool is_done = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  struct stat old {};
  if (is_done && ::stat(place.c_str(), &old) == 0 && S_ISREG(old.st_mode)) {
    // Only root may change an owner. The mode comes last, because a new owner clears some of its bits.
    if (::fchown(::fileno(stream), old.st_uid, old.st_gid) != 0) errno = 0;
    ::fchmod(::fileno(stream), old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
  }
  int fault = errno;
  if (std::fclose(stream) != 0 && is_done) {
    fault = errno;
    is_done = false;
  }
  if (is_done && std::rename(beside.c_str(), place.c_str()) == 0) return;
  if (is_done) fault = errno;
  ::unlink(beside.c_str());
  fail_to("write", place, std::strerror(fault));
}

/// The beginning of a file in every version: its first line. For JSON, whose first line is a bracket, its
/// first two fields without the value of the second.
std::string_view beginning_of(std::string_view text) {
  if (!text.starts_with('{')) return text.substr(0, text.find('\n'));
  return text.substr(0, text.find(':', text.find(':') + 1));  // npos + 1 is 0
}

/// Whether shadefit wrote the file at `path` under the name of `file`. Only a regular file can be ours.
bool is_own(const fs::path& path, const File& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  constexpr std::size_t last = 64;
  const std::string there = read_file(path);
  return file.name.ends_with(".svg")
             ? there.find(name_of_ours, there.size() - std::min(there.size(), last)) != std::string::npos
             : beginning_of(there) == beginning_of(file.content);
}

}  // namespace

std::string marked_picture(const std::string& svg) {
  return svg + "<!-- " + std::string(name_of_ours) + " -->\n";
}

void require_writable(const fs::path& directory) {
  if (directory.empty()) throw UserError("output directory '' is empty: name a directory");
  std::error_code error;
  const fs::path whole = fs::absolute(directory, error);
  if (error) fail_to("create directory", directory, error.message());
  fs::path part = whole;
  fs::file_status status = fs::symlink_status(part, error);
  while (status.type() == fs::file_type::not_found) {
    part = part.parent_path();
    status = fs::symlink_status(part, error);
  }
  if (!fs::status_known(status)) fail_to("create directory", directory, error.message());
  if (!fs::is_directory(part, error))
    fail_to("write to", directory, quoted_path(part) + " is not a directory");
  std::string trial = (part / ".shadefit-XXXXXX").string();
  if (::mkdtemp(trial.data()) == nullptr)
    fail_to(part == whole ? "write to" : "create directory", directory, std::strerror(errno));
  ::rmdir(trial.c_str());
}

void require_own(const fs::path& directory, const std::vector<File>& files) {
  for (const File& file : files) {
    const fs::path place = place_of(directory, file);
    std::error_code error;
    if (!fs::exists(fs::symlink_status(place, error)) || is_own(place, file)) continue;
    const bool is_empty = fs::is_regular_file(place, error) && fs::file_size(place, error) == 0;
    if (!is_empty && !fs::is_directory(place, error))
      throw UserError(quoted_path(place) +
                      " was not written by shadefit: move it away, or replace it with --force");
  }
}

void write_files(const fs::path& directory, const std::vector<File>& files) {
  require_writable(directory);
  for (const File& file : files) {
    const fs::path folder = (directory / file.name).parent_path();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail_to("create directory", folder, error.message());
    if (&file == &files.front()) remove_leftovers(folder);
    write_file(place_of(directory, file), file.content);
  }
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
    const fs::path place = place_of(directory, file);
    std::error_code error;
    if (is_own(place, file) && !fs::remove(place, error)) fail_to("remove", place, error.message());
  }
}

}  // namespace shadefit
