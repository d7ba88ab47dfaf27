#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/progress.hpp"
#include "bench/forms/kernel.hpp"

namespace CLI {
class App;
}

/// The subcommand `bench`.
namespace shadefit {

struct BenchOptions {
  std::string out = "out";
  std::vector<std::string> only;  ///< ids of targets
  bool force = false;             ///< as of `RunOptions`
  bool quick = false;
  bool json = false;
  bool no_plots = false;
  std::optional<std::string> width;       ///< "scalar", "sse2", "avx2" or "avx512"
  std::optional<std::string> exhaustive;  ///< the id of a form: every float, instead of times
  std::optional<std::string> constants;   ///< of that form; the rest is of it too
  std::optional<int> exp2_degree;
  std::optional<std::string> shard;
  std::optional<std::string> state;
  std::optional<std::string> range;
  std::vector<std::string> merge;
};

/// Declares the subcommand and what it is told.
CLI::App* add_bench_options(CLI::App& app, BenchOptions& options);

/// Times, or with --exhaustive every float. `version` is that of this program.
Outcome bench_command(const BenchOptions& options, const std::string& version, const Checkpoint& checkpoint,
                      const Progress& progress);

/// `bench --exhaustive`.
Outcome exhaustive_command(const BenchOptions& options, const std::string& version,
                           const Checkpoint& checkpoint, const Progress& progress);

/// The width of that name. Throws UserError for an unknown one and for one that this machine does not have.
forms::Width parse_width(const std::string& text);

}  // namespace shadefit
