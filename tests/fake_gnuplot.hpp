#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/temporary_directory.hpp"

/// A replacement of gnuplot, so that tests need no gnuplot and can make it fail.
namespace shadefit::testing {

/// An environment variable, put back at the end of its scope.
class EnvironmentVariable {
 public:
  EnvironmentVariable(std::string name, const std::string& value) : name_(std::move(name)) {
    if (const char* old = std::getenv(name_.c_str())) old_ = old;
    ::setenv(name_.c_str(), value.c_str(), 1);
  }
  ~EnvironmentVariable() {
    if (old_) {
      ::setenv(name_.c_str(), old_->c_str(), 1);
    } else {
      ::unsetenv(name_.c_str());
    }
  }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

 private:
  std::string name_;
  std::optional<std::string> old_;
};

/// Makes bin/gnuplot in `directory`, a shell script that finds the picture it shall write in $picture and the
/// script that it is given in $script, and returns its path.
inline std::string fake_gnuplot(const TemporaryDirectory& directory, const std::string& body) {
  const std::string path =
      directory.file("bin/gnuplot", "#!/bin/sh\nscript=$2; picture=${script%.gnuplot}.svg\n" + body + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

}  // namespace shadefit::testing
