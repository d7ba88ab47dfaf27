#pragma once

#include <functional>
#include <string>

/// How far long work has come, for somebody who watches.
namespace shadefit {

/// Shows a line in place of the one before; an empty one takes it away. Called often, it shows what a reader
/// can follow.
using Progress = std::function<void(const std::string& line)>;

/// Nobody watches.
inline void unwatched(const std::string&) {}

/// Writes to a terminal; where the descriptor is none, nothing is ever written.
Progress terminal_progress(int descriptor);

/// "what [####......] 43 %, 12 s left": a share from 0 to 1, and the seconds that it took. What is left is
/// not estimated before there is something to go by.
std::string progress_line(const std::string& what, double share, double seconds);

}  // namespace shadefit
