#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "bench/solver/benchmarks.hpp"
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
    if (!finished.is_well) {
      state.SkipWithError("the command failed");
      break;
    }
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
  const std::string a(fresnel_published[2].printed), b(fresnel_published[3].printed);
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

/// The published numbers of four digits and more in the studies of this repository, one a line.
void write_literals(const std::filesystem::path& file) {
  std::ofstream out(file);
  const std::regex number(R"re("-?([0-9.]{5,}(e-?[0-9]+)?)")re");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SHADEFIT_SOURCE_DIR "/studies")) {
    std::ifstream study(entry.path());
    for (std::string line; std::getline(study, line);) {
      if (!line.starts_with("values = ")) continue;
      for (std::sregex_iterator at(line.begin(), line.end(), number), end; at != end; ++at)
        out << (*at)[1].str() << '\n';
    }
  }
}

/// A tree as large as a large engine, warm: by lint, and by ripgrep with the same digits as fixed strings.
void measure_lint(benchmark::State& state, bool by_ripgrep) {
  const ScratchDirectory directory;
  const std::filesystem::path sources = directory.path() / "src", literals = directory.path() / "literals";
  write_sources(sources);
  write_literals(literals);
  measure(state, [&] {
    return by_ripgrep ? std::vector<std::string>{"rg", "-c", "-F", "-f", literals, sources}
                      : std::vector<std::string>{SHADEFIT_COMMAND, "lint", sources};
  });
}

template <class Measure, class... Arguments>
void register_command(const char* name, Measure measure, Arguments... arguments) {
  benchmark::RegisterBenchmark(name, measure, arguments...)->UseManualTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_process() {
  register_command("process/run-no-plots", measure_run);
  register_command("process/lint", measure_lint, false);
  if (run({"rg", "--version"}).is_well)
    register_command("process/lint/ripgrep", measure_lint, true);
  else
    std::fputs("process/lint/ripgrep is left out: rg is not installed\n", stderr);
  register_command("process/version", measure_start);
}

}  // namespace shadefit::bench
