#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reports/io/output.hpp"

namespace shadefit {

/// The directory of a run, which has it to itself from the beginning to the end.
class OutputFolder {
 public:
  /// Throws UserError where it cannot be written, or where another run has it.
  explicit OutputFolder(const std::string& directory)
      : output_(std::make_shared<Output>(directory, Company::refused)) {}

  /// Makes the files ready; the call puts them in their places. Throws UserError as `Output::prepare`.
  std::function<void()> prepare(const std::vector<File>& files, const std::vector<File>& obsolete, bool force,
                                const Checkpoint& checkpoint) const {
    output_->prepare(files, obsolete, force ? Foreign::replaced : Foreign::refused, checkpoint);
    return [output = output_] { output->put(); };
  }

 private:
  std::shared_ptr<Output> output_;
};

}  // namespace shadefit
