#pragma once

#include <string>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "fit/support/checkpoint.hpp"

/// All commands and options of `shadefit`. The help, the man page and the completions are generated from
/// these declarations.
namespace shadefit {

/// The environment of a command, and its outcome.
struct Call {
  Checkpoint checkpoint;
  const Progress& progress;
  Terminal terminal = {};
  Outcome outcome = {};
};

/// Declares the commands. Parsing arguments then runs the command that they name and sets `call.outcome`.
void declare_commands(CLI::App& app, Call& call);

/// The completion script for the commands, options and ids of `app`, for "bash", "zsh" or "fish"; or the
/// manual page, for "man". Throws UserError for any other word.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace shadefit
