#pragma once

#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// Thrown by a checkpoint when the time is over. Like Interrupted it is no std::exception: only the command
/// line catches it.
struct TimeIsOver {
  double seconds;  ///< that were given
};

/// A checkpoint that throws TimeIsOver once so many seconds have passed from now on. It calls `checkpoint`, a
/// copy of which it holds, first.
Checkpoint limited(const Checkpoint& checkpoint, double seconds);

}  // namespace shadefit
