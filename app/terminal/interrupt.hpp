#pragma once

#include <csignal>

#include "fit/support/checkpoint.hpp"

/// SIGINT, SIGTERM and SIGHUP as something that work looks for at its checkpoints, instead of a handler that
/// strikes anywhere.
namespace shadefit {

/// Thrown by a checkpoint that found a signal. No UserError, and no std::exception: nothing is wrong with the
/// input or the program, and only the command line catches it.
struct Interrupted {
  int signal;
};

/// Signals that are held back, and the mask of blocked signals from before.
struct HeldSignals {
  sigset_t held;
  sigset_t mask_before;
};

/// Blocks SIGINT, SIGTERM and SIGHUP in this thread and in those it will start; one that is ignored (a job in
/// the background of a script ignores SIGINT, one under nohup SIGHUP) stays so. From then on they wait until
/// a checkpoint looks for them.
///
/// A blocked mask outlives exec: a program that the command starts must be given `mask_before`, or Ctrl-C
/// will not end it.
HeldSignals hold_interrupts();

/// Takes the signals that wait, as of somebody who pressed Ctrl-C again while the first was being obeyed.
void take_waiting(const HeldSignals& signals);

/// Lets the signals of `hold_interrupts` do again what they did. One that still waits strikes now, without a
/// word: the command itself holds them to its end.
void release(const HeldSignals& signals);

/// A checkpoint that takes a waiting signal and throws Interrupted.
Checkpoint interruptible(const HeldSignals& signals);

}  // namespace shadefit
