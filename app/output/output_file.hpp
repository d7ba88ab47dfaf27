#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/io/output.hpp"

/// What an option --out names.
namespace shadefit {

/// The destination of an option --out that names a file. A link stays, and its target is written. An existing
/// destination that is not a regular file (a device, a pipe, an open descriptor such as /dev/stdout) is
/// written as a stream.
class OutputFile {
 public:
  /// Throws UserError if the text does not name a file, or names one that cannot be written. `what` names the
  /// content: "the certificate".
  OutputFile(const std::string& text, const std::string& what);

  /// Whether the content is written as a stream and no file is created.
  bool is_stream() const { return output_ == nullptr; }

  /// Prepares the file. The returned call moves it to its place or writes the stream. Throws UserError like
  /// `Output::prepare`.
  std::function<void()> prepare(const std::string& content, bool force, const Checkpoint& checkpoint) const;

 private:
  std::filesystem::path path_;
  std::shared_ptr<Output> output_;
};

/// The directory of a run, locked by the run from beginning to end.
class OutputFolder {
 public:
  /// Throws UserError if it cannot be written, or if another run uses it.
  explicit OutputFolder(const std::string& directory)
      : output_(std::make_shared<Output>(directory, Company::refused)) {}

  /// Prepares the files. The returned call moves them to their places. Throws UserError like
  /// `Output::prepare`.
  std::function<void()> prepare(const std::vector<File>& files, const std::vector<File>& obsolete, bool force,
                                const Checkpoint& checkpoint) const {
    output_->prepare(files, obsolete, force ? Foreign::replaced : Foreign::refused, checkpoint);
    return [output = output_] { output->put(); };
  }

 private:
  std::shared_ptr<Output> output_;
};

}  // namespace shadefit
