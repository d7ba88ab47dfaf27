#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/io/output.hpp"

/// What an option --out names.
namespace shadefit {

/// The destination of an option that names a file, --out or --plot. A link stays, and its target is written.
class OutputFile {
 public:
  /// Throws UserError if the text does not name a file, or names one that cannot be written. `what` names the
  /// content: "the certificate".
  OutputFile(const std::string& option, const std::string& text, const std::string& what);

  /// The returned call writes the file. Throws UserError if it is a foreign one and not to be replaced
  /// (`force`).
  std::function<void()> prepare(const std::string& content, bool force, const Checkpoint& checkpoint) const;

 private:
  std::filesystem::path folder_;
  std::string name_;
};

/// The directory of a run.
class OutputFolder {
 public:
  /// Throws UserError if it cannot be written.
  explicit OutputFolder(const std::string& directory) : directory_(directory) {
    require_writable(directory_);
  }

  /// The returned call writes the files and removes the obsolete ones of ours; the checkpoint is called for
  /// the last time before. Throws UserError if a file is a foreign one and not to be replaced (`force`).
  std::function<void()> prepare(const std::vector<File>& files, const std::vector<File>& obsolete, bool force,
                                const Checkpoint& checkpoint) const {
    if (!force) require_own(directory_, files);
    checkpoint();
    return [directory = directory_, files, obsolete] {
      write_files(directory, files);
      remove_own(directory, obsolete);
    };
  }

 private:
  std::filesystem::path directory_;
};

}  // namespace shadefit
