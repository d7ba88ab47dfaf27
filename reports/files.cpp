#include "reports/files.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "fit/user_error.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

fs::path beside(const fs::path& path) {
  return fs::path(path).concat(".partial");
}

void write_beside(const fs::path& path, const std::string& content) {
  errno = 0;
  std::ofstream out(beside(path), std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) throw UserError("cannot write " + quoted(path) + ": " + std::strerror(errno != 0 ? errno : EIO));
}

}  // namespace

void require_directory(const fs::path& directory) {
  if (directory.empty()) throw UserError("output directory '' is empty: name a directory");
  std::error_code ignored;
  for (fs::path part = fs::absolute(directory); part != part.root_path(); part = part.parent_path()) {
    if (fs::is_directory(part, ignored)) return;
    if (fs::exists(fs::symlink_status(part, ignored))) {
      const bool below = fs::absolute(directory).lexically_normal() != part.lexically_normal();
      throw UserError("output directory " + quoted(directory) +
                      (below ? " lies below " + quoted(part) + ", which is a file" : " is a file") +
                      ": it must be a directory, or free to become one");
    }
  }
}

void write_files(const fs::path& directory, const std::vector<File>& files) {
  require_directory(directory);
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw UserError("cannot create directory " + quoted(directory) + ": " + error.message());
  const auto remove_partial = [&] {
    std::error_code ignored;
    for (const File& file : files) fs::remove(beside(directory / file.name), ignored);
  };
  try {
    for (const File& file : files) {
      if (fs::is_directory(directory / file.name, error)) {
        throw UserError("cannot write " + quoted(directory / file.name) + ": it is a directory");
      }
      write_beside(directory / file.name, file.content);
    }
    for (const File& file : files) {
      fs::rename(beside(directory / file.name), directory / file.name, error);
      if (error) throw UserError("cannot write " + quoted(directory / file.name) + ": " + error.message());
    }
  } catch (...) {
    remove_partial();
    throw;
  }
}

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw UserError("cannot read " + quoted(path) + ": there is no such file");
  if (fs::is_directory(path, error)) throw UserError("cannot read " + quoted(path) + ": it is a directory");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  if (!in) throw UserError("cannot read " + quoted(path) + ": " + std::strerror(errno != 0 ? errno : EIO));
  return content.str();
}

}  // namespace shadefit
