#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"

/// Generated files that name the command that made them.
namespace shadefit {

/// A line that names a command: "shadefit scene 'a b.mtl' --lang glsl". A word with blanks or quotes
/// is in quotes. Throws UserError for a word that a comment cannot hold: line ends, control characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the command that a file of generated code names, in its comment, and compares: exit 1 where it would
/// print something else now. Throws UserError where it names none.
Outcome check_generated_file(const std::string& file, const Checkpoint& checkpoint);

}  // namespace shadefit
