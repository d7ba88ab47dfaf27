#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/io/output.hpp"

/// What an option --out or --plot names.
namespace shadefit {

/// The returned call writes the files and removes the obsolete ones of ours; the checkpoint is called for the
/// last time before. Throws UserError if a file is a foreign one and not to be replaced (`force`).
std::function<void()> prepare_output(const std::filesystem::path& directory, const std::vector<File>& files,
                                     const std::vector<File>& obsolete, bool force,
                                     const Checkpoint& checkpoint);

/// The file that an option names. A link stays, and the file to which it leads is returned. Throws UserError
/// if the text does not name a file, or names one that cannot be written. `what` names the content: "the
/// certificate".
std::filesystem::path output_file(const std::string& option, const std::string& text,
                                  const std::string& what);

/// The same as `prepare_output` for such a file.
std::function<void()> prepare_output_file(const std::filesystem::path& file, const std::string& content,
                                          bool force, const Checkpoint& checkpoint);

}  // namespace shadefit
