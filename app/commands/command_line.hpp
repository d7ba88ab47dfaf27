#pragma once

#include <string>
#include <vector>

#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "fit/support/checkpoint.hpp"
#include "reports/io/writers.hpp"

/// The command `shadefit`: arguments in, texts and exit code out.
namespace shadefit {

/// Runs the command; `arguments` without the program's name. Reads and writes files, never a standard stream.
/// Does not throw. `checkpoint` is called between the steps of long work. It may end the work by throwing
/// Interrupted (app/output/interrupt.hpp). Then nothing is written. `progress` shows the progress of the
/// work.
Outcome run_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint = keep_going,
                         const Progress& progress = unwatched);

/// The same in two steps, so that `out` can be printed between them: `put_files` calls `put`, and adds its
/// errors. `put` may call the checkpoint: it has to live until then. Tables are formatted for `terminal`.
Outcome prepare_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                             const Progress& progress, const Terminal& terminal = {});
Outcome put_files(Outcome outcome);

}  // namespace shadefit
