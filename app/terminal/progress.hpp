#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "fit/support/checkpoint.hpp"

/// How far long work has come, for somebody who watches.
namespace shadefit {

/// Shows a line in place of the one before; an empty one takes it away. Called often, it shows what a reader
/// can follow.
using Progress = std::function<void(const std::string& line)>;

/// Nobody watches.
inline void unwatched(const std::string&) {}

/// Writes to a terminal, once the work has taken as long as `patience`; where the descriptor is none, nothing
/// is ever written.
Progress terminal_progress(int descriptor, std::chrono::milliseconds patience = std::chrono::seconds(2));

/// How long work is looked at, and shown.
struct Watched {
  Checkpoint checkpoint;
  Progress progress;
};

/// A checkpoint that shows "what .. 12 s", but while the work shows a line of its own by the progress that
/// comes with it. So no command is silent for long that is looked at often. Both arguments have to stay.
Watched watch(const Checkpoint& checkpoint, const Progress& progress, const std::string& what);

/// Shows the share of the work that is done, from 0 to 1, and the time that is left. `progress` has to stay.
std::function<void(double share)> bar(const Progress& progress, const std::string& what);

/// A checkpoint to be called before each of so many steps, which shows the share that is done; of one step
/// there is none to show. Both have to stay.
Checkpoint stepping(const Checkpoint& checkpoint, const Progress& progress, const std::string& what,
                    std::size_t steps);

/// "what [####......] 43 %, 12 s left": a share from 0 to 1, and the seconds that it took. What is left is
/// not estimated before there is something to go by.
std::string progress_line(const std::string& what, double share, double seconds);

}  // namespace shadefit
