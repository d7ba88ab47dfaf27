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
#include "app/output/interrupt.hpp"
#include "app/output/print.hpp"

namespace {

/// The outcome of a run whose results could not be printed. Its prepared files are not written.
shadefit::Outcome not_printed(const shadefit::Printed& printed) {
  if (printed.signal > 0)
    return {128 + printed.signal, "", "shadefit: interrupted while printing, no file was written\n"};
  return {2, "",
          std::string("shadefit: cannot write standard output: ") + std::strerror(printed.error) + "\n"};
}

/// Occupies the descriptors of closed standard streams, so that no file of ours gets one of them. Writing to
/// such a stream still fails.
void fill_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// The terminal behind a descriptor. Colours can be disabled by NO_COLOR (https://no-color.org).
shadefit::Terminal terminal_of(int descriptor) {
  if (::isatty(descriptor) == 0) return {};
  const char *type = std::getenv("TERM"), *no_colour = std::getenv("NO_COLOR");
  const bool is_plain =
      type == nullptr || std::string_view(type) == "dumb" || (no_colour != nullptr && *no_colour != '\0');
  winsize size{};
  ::ioctl(descriptor, TIOCGWINSZ, &size);
  return {.width = size.ws_col, .has_colour = !is_plain};
}

/// Ends the process by a signal, like every filter that loses its reader.
void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit then becomes a normal error of that file.
  std::signal(SIGXFSZ, SIG_IGN);
  // So does a reader of our output that has gone.
  std::signal(SIGPIPE, SIG_IGN);
  fill_standard_streams();
  const auto signals = shadefit::hold_interrupts();
  const auto progress = shadefit::terminal_progress(STDERR_FILENO);
  const auto checkpoint = shadefit::interruptible(signals);
  auto outcome = shadefit::prepare_command_line({argv + 1, argv + argc}, checkpoint, progress,
                                                terminal_of(STDOUT_FILENO));
  progress("");
  // The user may press Ctrl-C again while the first is handled.
  const bool is_interrupted = outcome.exit_code > 128;
  while (is_interrupted && shadefit::take_signal(signals) > 0) {
  }
  // The signals stay held: printing checks for them, and none can end the process without a message.
  const auto printed = shadefit::print(STDOUT_FILENO, outcome.out, signals);
  if (printed.error == EPIPE && !outcome.put) end_by(SIGPIPE);
  outcome = printed.is_whole() ? shadefit::put_files(std::move(outcome)) : not_printed(printed);
  shadefit::print(STDERR_FILENO, outcome.err, signals);
  return outcome.exit_code;
}
