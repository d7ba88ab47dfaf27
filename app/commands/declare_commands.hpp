#pragma once

#include "app/options/options.hpp"
#include "app/options/outcome.hpp"
#include "app/terminal/progress.hpp"
#include "fit/support/checkpoint.hpp"

namespace CLI {
class App;
}

/// Every command and option of `shadefit`, in one place: the help, the man page and the completions are made
/// from these declarations.
namespace shadefit {

/// What a command runs with, and what came of it.
struct Call {
  const Checkpoint& checkpoint;
  const Progress& progress;
  Terminal terminal = {};
  Outcome outcome = {};
};

/// Declares the commands. A parse of arguments then runs the one that they name, and sets `call.outcome`.
void declare_commands(CLI::App& app, Call& call);

}  // namespace shadefit
