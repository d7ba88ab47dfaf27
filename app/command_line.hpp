#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/progress.hpp"
#include "fit/support/checkpoint.hpp"

/// The command `shadefit`: arguments in, texts and exit code out.
namespace shadefit {

struct Outcome {
  int exit_code = 0;  ///< 0; 1 a check, a fit or a plot failed; 2 bad usage or bad input; 128 + a signal that
                      ///< interrupted it
  std::string out;    ///< for standard output
  std::string err;    ///< for standard error
  /// Puts the files that are ready in their places; empty where there are none. It is for after `out` is
  /// printed: where nobody can be told of a file, none is written. Throws UserError and Interrupted.
  std::function<void()> put = {};
};

/// Runs the command; `arguments` without the program's name. Reads and writes files as the subcommand says,
/// never a standard stream. Does not throw. `checkpoint` is called between the steps of long work and may end
/// it by throwing Interrupted (app/interrupt.hpp): nothing is written then, but by commands that keep a state
/// to go on from and say so. `progress` is shown how far that work is.
Outcome run_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint = keep_going,
                         const Progress& progress = unwatched);

/// The same in two steps, between which `out` can be printed: `put_files` calls `put`, and says what went
/// wrong. `put` may call the checkpoint: both arguments have to stay until then.
Outcome prepare_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                             const Progress& progress);
Outcome put_files(Outcome outcome);

}  // namespace shadefit
