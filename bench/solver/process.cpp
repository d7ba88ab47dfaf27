#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "bench/solver/benchmarks.hpp"

namespace shadefit::bench {
namespace {

/// A directory that is removed with the value.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = std::filesystem::temp_directory_path() / "shadefit-bench-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Usage {
  double seconds;  ///< from the start of the process to its end, by the clock
  double peak_mb;  ///< the largest resident set, in 10^6 bytes
};

/// Runs the built command to its end and discards its standard output; empty if it failed. Linux includes the
/// memory of this process at the start in the peak of its child. So the peak is an upper bound, and exact if
/// the child becomes larger than its parent, as here.
std::optional<Usage> run_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SHADEFIT_COMMAND);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);

  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int error = ::posix_spawn(&child, argv.front(), &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return std::nullopt;
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, 0, &usage) != child) return std::nullopt;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return Usage{time.count(), static_cast<double>(usage.ru_maxrss) * 1024 / 1e6};
}

/// Each run gets a new directory, so that it writes all of its files.
void measure_run(benchmark::State& state) {
  double peak = 0;
  for (auto _ : state) {
    const TemporaryDirectory directory;
    const auto usage = run_command({"run", "--no-plots", "--out", directory.path() / "out"});
    if (!usage) {
      state.SkipWithError("the command failed");
      break;
    }
    state.SetIterationTime(usage->seconds);
    peak = std::max(peak, usage->peak_mb);
  }
  state.counters["peak_MB"] = peak;
}

/// The cost of a process: the same command with nothing to do.
void measure_start(benchmark::State& state) {
  for (auto _ : state) {
    const auto usage = run_command({"--version"});
    if (!usage) {
      state.SkipWithError("the command failed");
      break;
    }
    state.SetIterationTime(usage->seconds);
  }
}

}  // namespace

void register_process() {
  benchmark::RegisterBenchmark("process/run-no-plots", measure_run)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("process/version", measure_start)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace shadefit::bench
