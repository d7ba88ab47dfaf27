#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "fit/support/checkpoint.hpp"

/// All commands and options of `shadefit`. The help, the manual page and the completions are generated from
/// these declarations.
namespace shadefit {

/// The environment of a command, and the command that was parsed.
struct Call {
  Watched work;
  Terminal terminal = {};
  std::function<Outcome()> run = {};
};

/// Declares the commands. Parsing arguments then sets `call.run` to the command that they name.
void declare_commands(CLI::App& app, Call& call);

/// The script that completes the commands, options and ids of `app` in "bash" or "zsh"; or the manual page,
/// for "man". Throws UserError for any other word.
std::string completion(const CLI::App& app, const std::string& shell);

/// The libraries inside the command with their versions, as one line without an end: "with Boost 1.74.0, ..,
/// zlib 1.2.13". GMP, MPFR and MPFI are asked when the command runs, since a user can exchange them; the
/// others are those that it was built with.
std::string libraries_inside();

}  // namespace shadefit
