#pragma once

#include <string>
#include <vector>

#include "app/options/finding_format.hpp"
#include "app/options/outcome.hpp"
#include "fit/support/checkpoint.hpp"

/// Generated files that name the command that made them.
namespace shadefit {

/// A command as a line for a shell: "shadefit scene 'a b.mtl' --lang glsl".
std::string shell_text(const std::vector<std::string>& words);

/// The same for a comment. Throws UserError for a word with line ends or control characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the command named in the comment of a generated file and compares the output: exit 1 if it would
/// print something else now. The files of a scene are relative to the folder of `file`. Throws UserError if
/// the file names no command.
Outcome check_generated_file(const std::string& file, FindingFormat format, const Checkpoint& checkpoint);

}  // namespace shadefit
