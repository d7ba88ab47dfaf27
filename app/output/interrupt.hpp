#pragma once

#include <csignal>

#include "fit/support/checkpoint.hpp"

/// Work checks for SIGINT, SIGTERM and SIGHUP at its checkpoints, instead of a handler that can run anywhere.
namespace shadefit {

/// Thrown by a checkpoint that found a signal. It is neither a UserError nor a std::exception, because
/// neither the input nor the program is wrong. Only the command line catches it.
struct Interrupted {
  int signal;
};

/// Thrown by a checkpoint when the time is over. It is caught as Interrupted is.
struct TimeIsOver {
  double seconds;  ///< that were given
};

/// Blocks SIGINT, SIGTERM and SIGHUP in this thread and in the threads that it starts. An ignored signal
/// stays ignored (a background job of a script ignores SIGINT, a job under nohup ignores SIGHUP). From then
/// on the signals are pending until a checkpoint takes them. The command holds them to its end.
sigset_t hold_interrupts();

/// Takes a pending signal; returns a number <= 0 if none is pending.
int take_signal(const sigset_t& held);

/// A checkpoint that takes a pending signal and throws Interrupted.
Checkpoint interruptible(const sigset_t& held);

/// A checkpoint that throws TimeIsOver once so many seconds have passed from now on. It calls `checkpoint`, a
/// copy of which it holds, first.
Checkpoint limited(const Checkpoint& checkpoint, double seconds);

}  // namespace shadefit
