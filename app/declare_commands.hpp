#pragma once

#include "app/options.hpp"
#include "app/outcome.hpp"
#include "app/progress.hpp"
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
