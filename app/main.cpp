#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "app/commands/command_line.hpp"
#include "app/terminal/interrupt.hpp"
#include "app/terminal/print.hpp"

namespace {

/// How a run ends whose results could not be printed. The files that it made ready are not put.
shadefit::Outcome not_printed(const shadefit::Printed& printed) {
  if (printed.signal > 0)
    return {128 + printed.signal, "", "shadefit: interrupted while printing, no file was written\n"};
  return {2, "",
          std::string("shadefit: cannot write standard output: ") + std::strerror(printed.error) + "\n"};
}

/// Takes the numbers of standard streams that are closed, so that no file of ours gets one of them. Writing
/// to such a stream fails still.
void fill_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// The terminal behind a descriptor. Colours are for those who did not ask for none (https://no-color.org).
shadefit::Terminal terminal_of(int descriptor) {
  if (::isatty(descriptor) == 0) return {};
  const char *type = std::getenv("TERM"), *no_colour = std::getenv("NO_COLOR");
  const bool is_plain =
      type == nullptr || std::string_view(type) == "dumb" || (no_colour != nullptr && *no_colour != '\0');
  winsize size{};
  ::ioctl(descriptor, TIOCGWINSZ, &size);
  return {.width = size.ws_col, .has_colour = !is_plain};
}

/// As every filter ends whose reader has gone.
void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow further is then an error of that file, told like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  // So is a reader of ours that has gone.
  std::signal(SIGPIPE, SIG_IGN);
  fill_standard_streams();
  const auto signals = shadefit::hold_interrupts();
  const auto progress = shadefit::terminal_progress(STDERR_FILENO);
  const auto checkpoint = shadefit::interruptible(signals);
  auto outcome = shadefit::prepare_command_line({argv + 1, argv + argc}, checkpoint, progress,
                                                terminal_of(STDOUT_FILENO));
  progress("");
  // Somebody who pressed Ctrl-C again while the first was being obeyed.
  const bool is_interrupted = outcome.exit_code > 128;
  if (is_interrupted) shadefit::take_waiting(signals);
  // The signals stay held: printing looks for them, and none can end the process without a word.
  const auto printed = shadefit::print(STDOUT_FILENO, outcome.out, signals);
  if (printed.error == EPIPE && !outcome.put) end_by(SIGPIPE);
  outcome = printed.is_whole() ? shadefit::put_files(std::move(outcome)) : not_printed(printed);
  shadefit::print(STDERR_FILENO, outcome.err, signals);
  return outcome.exit_code;
}
