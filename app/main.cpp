#include <cerrno>
#include <cstdio>
#include <cstring>

#include "app/command_line.hpp"

int main(int argc, char** argv) {
  const auto outcome = shadefit::run_command_line({argv + 1, argv + argc});
  const bool is_written = std::fputs(outcome.out.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (!is_written) std::fprintf(stderr, "shadefit: cannot write standard output: %s\n", std::strerror(errno));
  std::fputs(outcome.err.c_str(), stderr);
  return is_written ? outcome.exit_code : 2;
}
