#pragma once

#include <string>
#include <vector>

#include "app/options/outcome.hpp"
#include "fit/support/checkpoint.hpp"

/// Generated files that name the command that made them.
namespace shadefit {

/// A command as a line for a shell: "shadefit scene 'a b.mtl' --lang glsl".
std::string shell_text(const std::vector<std::string>& words);

/// The same for a comment. Throws UserError for a word with line ends or control characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the command that a file of generated code names, in its comment, and compares: exit 1 where it would
/// print something else now. The files of a scene are looked for from the folder of `file`. Throws UserError
/// where it names none.
Outcome check_generated_file(const std::string& file, const Checkpoint& checkpoint);

}  // namespace shadefit
