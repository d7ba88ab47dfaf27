#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "bench/solver/benchmarks.hpp"
#include "fit/catalogue/published.hpp"
#include "reports/io/scratch_directory.hpp"

namespace shadefit::bench {
namespace {

/// A finished process.
struct Finished {
  bool is_well;    ///< exit code 0
  double seconds;  ///< from its start to its end, by the clock
  /// The largest resident set, in 10^6 bytes. Linux includes the memory of this process at the start in the
  /// peak of its child. So the peak is an upper bound, and exact if the child becomes larger than its parent.
  double peak_mb;
};

/// Runs a program, found by PATH, to its end, without input and output.
Finished run(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& text : arguments) argv.push_back(text.data());
  argv.push_back(nullptr);
  ::posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_RDWR, 0);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, argv.front(), &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  rusage usage{};
  const bool has_ended = error == 0 && ::wait4(child, &status, 0, &usage) == child;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {has_ended && WIFEXITED(status) && WEXITSTATUS(status) == 0, time.count(),
          static_cast<double>(usage.ru_maxrss) * 1024 / 1e6};
}

/// Times the processes of a program, each with the arguments that `arguments` makes for it.
template <class Arguments>
void measure(benchmark::State& state, const Arguments& arguments) {
  double peak = 0;
  for (auto _ : state) {
    const Finished finished = run(arguments());
    require(finished.is_well, "the command failed");
    state.SetIterationTime(finished.seconds);
    peak = std::max(peak, finished.peak_mb);
  }
  state.counters["peak_MB"] = peak;
}

/// Each run gets a new directory, so that it writes all of its files.
void measure_run(benchmark::State& state) {
  const ScratchDirectory directory;
  int runs = 0;
  measure(state, [&] {
    return std::vector<std::string>{SHADEFIT_COMMAND, "run", "--no-plots", "--out",
                                    directory.path() / std::to_string(runs++)};
  });
}

/// The cost of a process: the same command with nothing to do.
void measure_start(benchmark::State& state) {
  measure(state, [] { return std::vector<std::string>{SHADEFIT_COMMAND, "--version"}; });
}

/// 10 000 files of 15 kB, as large as a large engine: lines of code with numbers, the same in each run. Each
/// hundredth has a published pair.
void write_sources(const std::filesystem::path& folder) {
  constexpr int folders = 100, files_in_each = 100;
  constexpr std::size_t bytes = 15'000;
  const std::string a(find_published("fresnel-quadratic-a")->printed),
      b(find_published("fresnel-quadratic-b")->printed);
  std::minstd_rand numbers(1);
  for (int i = 0; i < folders * files_in_each; ++i) {
    const std::filesystem::path inner = folder / std::to_string(i / files_in_each);
    std::filesystem::create_directories(inner);
    std::string text;
    if (i % 100 == 0) text = "float f(float c) { return exp2((" + a + " * c + " + b + ") * c); }\n";
    while (text.size() < bytes) {
      const auto number = [&] { return std::to_string(numbers() % 100'000); };
      text += "  color[" + number() + "] = mix(first.rgb, second[index], 0." + number() + ") * " + number() +
              ".5f + offset;  // the weight of a layer\n";
    }
    std::ofstream(inner / (std::to_string(i) + ".glsl")) << text;
  }
}

/// A tree as large as a large engine, warm.
void measure_lint(benchmark::State& state) {
  const ScratchDirectory directory;
  write_sources(directory.path());
  measure(state, [&] { return std::vector<std::string>{SHADEFIT_COMMAND, "lint", directory.path()}; });
}

}  // namespace

void register_process() {
  const auto register_one = [](const char* name, auto measure_command) {
    benchmark::RegisterBenchmark(name, measure_command)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  register_one("process/run-no-plots", measure_run);
  register_one("process/lint", measure_lint);
  register_one("process/version", measure_start);
}

}  // namespace shadefit::bench
