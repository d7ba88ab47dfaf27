#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "fit/support/checkpoint.hpp"
#include "reports/io/output.hpp"

namespace shadefit {

/// Where an option --out that names a file puts it. A link stays, and what it leads to is written. What is
/// there and is not a regular file (a device, a pipe, an open descriptor such as /dev/stdout) is written to.
class OutputFile {
 public:
  /// Throws UserError where the text names no file, or one that cannot be written; `what` is what the file is
  /// for: "the certificate".
  OutputFile(const std::string& text, const std::string& what);

  /// Whether the content goes through what is there, and no file is made.
  bool is_stream() const { return output_ == nullptr; }

  /// Makes the file ready; the call puts it in its place, or writes the stream. Throws UserError as
  /// `Output::prepare`.
  std::function<void()> prepare(const std::string& content, bool force, const Checkpoint& checkpoint) const;

 private:
  std::filesystem::path path_;
  std::shared_ptr<Output> output_;
};

}  // namespace shadefit
