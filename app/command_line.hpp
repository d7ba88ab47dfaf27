#pragma once

#include <string>
#include <vector>

#include "app/progress.hpp"
#include "fit/checkpoint.hpp"

/// The command `shadefit`: arguments in, texts and exit code out.
namespace shadefit {

struct Outcome {
  int exit_code = 0;  ///< 0; 1 a check, a fit or a plot failed; 2 bad usage or bad input; 128 + a signal that
                      ///< interrupted it
  std::string out;    ///< for standard output
  std::string err;    ///< for standard error
};

/// Runs the command; `arguments` without the program's name. Reads and writes files as the subcommand says,
/// never a standard stream but to show `progress`. Does not throw. `checkpoint` is called between the steps
/// of long work and may end it by throwing Interrupted (app/interrupt.hpp): nothing is written then.
Outcome run_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint = keep_going,
                         const Progress& progress = in_silence);

}  // namespace shadefit
