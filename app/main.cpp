#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "app/command_line.hpp"
#include "app/interrupt.hpp"
#include "app/print.hpp"

namespace {

/// Prints; empty, or the exit code and the line for standard error where that went wrong.
shadefit::Outcome print_all(const shadefit::Outcome& outcome, const shadefit::HeldSignals& signals) {
  using shadefit::Printed;
  const auto printed = shadefit::print(STDOUT_FILENO, outcome.out, signals);
  if (printed.signal > 0)
    return {128 + printed.signal, "",
            "shadefit: interrupted while printing: what was to be written to files is written\n"};
  if (printed.error != 0)
    return {2, "",
            std::string("shadefit: cannot write standard output: ") + std::strerror(printed.error) + "\n"};
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow further is then an error of that file, told like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  const auto signals = shadefit::hold_interrupts();
  const auto progress = shadefit::terminal_progress(STDERR_FILENO);
  const auto outcome =
      shadefit::run_command_line({argv + 1, argv + argc}, shadefit::interruptible(signals), progress);
  progress("");
  // Somebody who pressed Ctrl-C again while the first was being obeyed.
  const bool is_interrupted = outcome.exit_code > 128;
  if (is_interrupted) shadefit::take_waiting(signals);
  // The signals stay held: from here on printing looks for them, and none can end the process without a word.
  const auto told = print_all(outcome, signals);
  shadefit::print(STDERR_FILENO, told.err, signals);
  return told.exit_code;
}
