#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reports/io/output.hpp"

namespace shadefit {

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
