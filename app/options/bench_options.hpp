#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/options/outcome.hpp"
#include "app/output/progress.hpp"
#include "bench/forms/float_errors.hpp"
#include "reports/io/writers.hpp"

namespace CLI {
class App;
}

/// The command `bench`.
namespace shadefit {

struct BenchOptions {
  std::optional<std::string> study = {};  ///< the id or the file of a study, instead of the catalogue
  std::vector<std::string> studies = {};  ///< folders that have it too
  std::string out = "out";
  std::vector<std::string> only = {};  ///< ids of targets
  bool force = false;                  ///< as in `RunOptions`
  bool quick = false;
  bool no_plots = false;
  std::optional<std::string> exhaustive = {};  ///< the id of a form: every float, instead of times
  std::optional<std::string> constants = {};   ///< of that form; the range is for it too
  bench::Stretch range = bench::unit_floats;
  /// The place of a Vulkan device among `device::vulkan_devices`, instead of the CPU.
  std::optional<std::size_t> device = {};
  bool list_devices = false;
  Terminal terminal = {};
};

/// Declares its options.
void declare_bench(CLI::App& bench, BenchOptions& options);

/// Measures times, or does what --exhaustive or --list-devices asks for.
Outcome bench_command(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress);

/// `bench --exhaustive`.
Outcome exhaustive_command(const BenchOptions& options, const Checkpoint& checkpoint,
                           const Progress& progress);

}  // namespace shadefit
