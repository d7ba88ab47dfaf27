#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

/// The command as a process of its own.
namespace shadefit::testing {

struct Finished {
  int exit_code;  ///< -1 where a signal ended it
  std::string out;
  std::string err;
};

inline std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer;
  for (ssize_t n; (n = ::read(descriptor, buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(n));
  ::close(descriptor);
  return text;
}

/// Runs the built command; `prepare` runs in the child before it, with its standard streams in place, and may
/// change them. Standard output and standard error are read from pipes; the latter must fit into one.
inline Finished run_process(std::vector<std::string> arguments, const std::function<void()>& prepare) {
  std::array<int, 2> out{}, err{};
  if (::pipe(out.data()) != 0 || ::pipe(err.data()) != 0) return {-1, "", "no pipe"};
  std::vector<char*> argv;
  arguments.insert(arguments.begin(), SHADEFIT_COMMAND);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(out[1], STDOUT_FILENO);
    ::dup2(err[1], STDERR_FILENO);
    for (const int descriptor : {out[0], out[1], err[0], err[1]}) ::close(descriptor);
    prepare();
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }
  ::close(out[1]);
  ::close(err[1]);
  Finished finished{-1, read_all(out[0]), read_all(err[0])};
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) finished.exit_code = WEXITSTATUS(status);
  return finished;
}

/// For `prepare`: no file may grow beyond `bytes`, as on a disk that is full from there on.
inline void limit_file_size(rlim_t bytes) {
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// For `prepare`: standard output goes to a file.
inline void send_output_to(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(file, STDOUT_FILENO);
  ::close(file);
}

/// For `prepare`: a signal that waits, blocked, which outlives the start of the command. So it is there from
/// the command's first instruction on, and no test depends on when it arrives.
inline void leave_pending(int signal, void (*disposition)(int)) {
  std::signal(signal, disposition);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  std::raise(signal);
}

}  // namespace shadefit::testing
