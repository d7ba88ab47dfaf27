#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {

/// The directory of temporary files as std::filesystem::temp_directory_path finds it: the first of the
/// variables below that is set, else /tmp. Throws UserError naming the variable if that is not a directory.
inline std::filesystem::path temporary_directory() {
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    const char* value = std::getenv(variable);
    if (value == nullptr || *value == '\0') continue;
    std::error_code error;
    if (std::filesystem::is_directory(value, error)) return value;
    if (!error) error = std::make_error_code(std::errc::not_a_directory);
    throw UserError(fmt::format("{} '{}' is not a directory: {}", variable, value, error.message()));
  }
  return "/tmp";
}

/// A temporary directory of this run, removed with its contents.
class ScratchDirectory {
 public:
  /// Throws UserError if it cannot be created.
  ScratchDirectory() {
    std::string name = (temporary_directory() / "shadefit-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw UserError(
          fmt::format("cannot create a directory for temporary files, '{}': {}", name, std::strerror(errno)));
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace shadefit
