#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include "app/command_line.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"

namespace {

bool write(std::FILE* stream, const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow further is then an error of that file, told like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  const auto signals = shadefit::hold_interrupts();
  const auto outcome = shadefit::run_command_line({argv + 1, argv + argc}, shadefit::interruptible(signals),
                                                  shadefit::terminal_progress());
  const bool is_interrupted = outcome.exit_code > 128;
  if (is_interrupted) shadefit::take_waiting(signals);
  // What is left is to print, which a reader may keep waiting for as long as it likes.
  shadefit::release(signals);
  errno = 0;
  const bool is_written = write(stdout, outcome.out);
  if (!is_written) {
    write(stderr, std::string("shadefit: cannot write standard output: ") + std::strerror(errno) + "\n");
    return 2;
  }
  write(stderr, outcome.err);
  return outcome.exit_code;
}
