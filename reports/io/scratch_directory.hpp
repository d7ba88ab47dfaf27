#pragma once

#include <stdlib.h>

#include <boost/core/noncopyable.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "fit/support/user_error.hpp"

namespace shadefit {

/// A temporary directory of this run, removed with its contents.
class ScratchDirectory : boost::noncopyable {
 public:
  /// Throws UserError if it cannot be created.
  ScratchDirectory() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "shadefit-XXXXXX").string();
    if (error) throw UserError("TMPDIR names no directory for temporary files: " + error.message());
    if (::mkdtemp(name.data()) == nullptr)
      throw UserError("cannot create a directory for temporary files: " + std::string(std::strerror(errno)));
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace shadefit
