#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "fit/support/checkpoint.hpp"

/// Progress of long work, for a user at a terminal.
namespace shadefit {

/// Shows a line in place of the previous one; an empty line removes it. It may be called often and limits how
/// often it prints.
using Progress = std::function<void(const std::string& line)>;

/// Shows nothing.
inline void unwatched(const std::string&) {}

/// Writes to a terminal, once the work has taken longer than `patience`. Writes nothing if the descriptor is
/// not a terminal.
Progress terminal_progress(int descriptor, std::chrono::milliseconds patience = std::chrono::seconds(2));

/// The checkpoint and the progress of long work.
struct Watched {
  Checkpoint checkpoint;
  Progress progress;
};

/// A checkpoint that shows "what .. 12 s", except while the work shows its own line by the returned progress.
/// So a command with frequent checkpoints is never silent for long. Both arguments must outlive the result.
Watched watch(const Checkpoint& checkpoint, const Progress& progress, const std::string& what);

/// Calls the checkpoint, and shows the finished fraction of the work, from 0 to 1, and the remaining time.
/// `work` must outlive the result.
std::function<void(double share)> bar(const Watched& work, const std::string& what);

/// A checkpoint to be called before each of `steps` steps. It shows the finished fraction, or nothing for a
/// single step. `work` must outlive the result.
Checkpoint stepping(const Watched& work, const std::string& what, std::size_t steps);

/// "what 43 %, 12 s left": a fraction from 0 to 1, and the seconds that it took. The remaining
/// time is estimated only after enough progress.
std::string progress_line(const std::string& what, double share, double seconds);

}  // namespace shadefit
