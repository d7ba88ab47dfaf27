#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <regex>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "approx/fresnel.hpp"
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

/// Runs a program, found on the path, to its end and discards its standard output; empty if it failed. Linux
/// includes the memory of this process at the start in the peak of its child. So the peak is an upper bound,
/// and exact if the child becomes larger than its parent, as here.
std::optional<Usage> run_program(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  ::posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);

  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, argv.front(), &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return std::nullopt;
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, 0, &usage) != child) return std::nullopt;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return Usage{time.count(), static_cast<double>(usage.ru_maxrss) * 1024 / 1e6};
}

/// Runs the built command.
std::optional<Usage> run_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SHADEFIT_COMMAND);
  return run_program(std::move(arguments));
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
  const TemporaryDirectory directory;
  const std::filesystem::path sources = directory.path() / "src", literals = directory.path() / "literals";
  write_sources(sources);
  write_literals(literals);
  double peak = 0;
  for (auto _ : state) {
    const auto usage = by_ripgrep ? run_program({"rg", "-c", "-F", "-f", literals, sources})
                                  : run_command({"lint", sources});
    if (!usage) {
      state.SkipWithError("the command failed");
      break;
    }
    state.SetIterationTime(usage->seconds);
    peak = std::max(peak, usage->peak_mb);
  }
  state.counters["peak_MB"] = peak;
}

}  // namespace

void register_process() {
  benchmark::RegisterBenchmark("process/run-no-plots", measure_run)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("process/lint", measure_lint, false)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  if (run_program({"rg", "--version"}))
    benchmark::RegisterBenchmark("process/lint/ripgrep", measure_lint, true)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  else
    std::fputs("process/lint/ripgrep is left out: rg is not installed\n", stderr);
  benchmark::RegisterBenchmark("process/version", measure_start)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace shadefit::bench
