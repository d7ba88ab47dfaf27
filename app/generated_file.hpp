#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"

/// Generated files that name the command that made them.
namespace shadefit {

/// A line that names a command: "shadefit scene 'a b.mtl' --lang glsl", for a shell: pasted, it makes that
/// call and nothing else. Throws UserError for a word that a comment cannot hold: line ends, control
/// characters.
std::string command_text(const std::vector<std::string>& words);

/// Runs the command that a file of generated code names, in its comment, and compares: exit 1 where it would
/// print something else now. The files of a scene are looked for from the folder of `file`. Throws UserError
/// where it names none.
Outcome check_generated_file(const std::string& file, const Checkpoint& checkpoint);

}  // namespace shadefit
