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

/// A file written beside its place, under a name of this process's own, and removed again unless it was
/// renamed.
class PartialFile {
 public:
  PartialFile(const fs::path& place, const std::string& content)
      : place_(place),
        partial_(place.parent_path() / fmt::format(".{}.{}.partial", place.filename().string(), ::getpid())) {
    errno = 0;
    std::FILE* file =
        std::fopen(partial_.c_str(), "wbx");  // x: never through a file or link that is already there
    if (file == nullptr) fail(errno);
    const bool is_written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
    const bool is_flushed = std::fclose(file) == 0;
    if (!is_written || !is_flushed) {
      const int error = errno;
      remove();
      fail(error);
    }
  }
  ~PartialFile() { remove(); }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  void rename() {
    std::error_code error;
    fs::rename(partial_, place_, error);
    if (error) throw UserError("cannot write " + quoted(place_) + ": " + error.message());
  }

 private:
  [[noreturn]] void fail(int error) const {
    throw UserError("cannot write " + quoted(place_) + ": " + std::strerror(error != 0 ? error : EIO));
  }
  void remove() const {
    std::error_code ignored;
    fs::remove(partial_, ignored);
  }

  fs::path place_, partial_;
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

void write_files(const fs::path& directory, const std::vector<File>& files) {
  require_directory(directory);
  std::error_code error;
  const bool is_new = fs::create_directories(directory, error);
  if (error) throw UserError("cannot create directory " + quoted(directory) + ": " + error.message());
  try {
    std::list<PartialFile> partial;
    for (const File& file : files) {
      if (fs::is_directory(directory / file.name, error)) {
        throw UserError("cannot write " + quoted(directory / file.name) + ": it is a directory");
      }
      partial.emplace_back(directory / file.name, file.content);
    }
    for (PartialFile& file : partial) file.rename();
  } catch (const UserError&) {
    if (is_new) fs::remove(directory, error);
    throw;
  }
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
