#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/options/finding_format.hpp"
#include "app/options/outcome.hpp"
#include "app/terminal/progress.hpp"
#include "bench/exhaustive/float_errors.hpp"
#include "bench/forms/kernel.hpp"
#include "reports/table/writers.hpp"

/// The command `bench`.
namespace shadefit {

struct BenchOptions {
  std::optional<std::string> study = {};  ///< the id or the file of a study, instead of the catalogue
  std::vector<std::string> studies = {};  ///< folders that have it too
  std::string out = "out";
  std::vector<std::string> only = {};  ///< ids of targets
  bool force = false;                  ///< as in `RunOptions`
  bool quick = false;
  FindingFormat format = FindingFormat::text;  ///< json: the times, as Google Benchmark prints them
  std::optional<std::string> compare = {};     ///< a file of `bench --json`
  double fail_above = 0.1;                     ///< how much longer a form may take than there: 0.1 is 10 %
  bool no_plots = false;
  std::optional<forms::Width> width = {};
  std::optional<std::string> exhaustive = {};  ///< the id of a form: every float, instead of times
  std::optional<std::string> constants = {};   ///< of that form; the options below are for it too
  int exp2_degree = 0;                         ///< 0: the library's exp2
  bench::Stretch range = bench::unit_floats;
  /// The place of a Vulkan device among `device::vulkan_devices`, instead of the CPU.
  std::optional<std::size_t> device = {};
  bool half = false;  ///< with `exhaustive` on a device: every half, in place of every float
  bool list_devices = false;
  bool probe = false;  ///< measure the functions of the device
  Terminal terminal = {};
};

/// Declares its options.
void declare_bench(CLI::App& bench, BenchOptions& options);

/// Measures times, or with --exhaustive compares every float.
Outcome bench_command(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress);

/// `bench --list-devices`: a line for each device.
Outcome list_devices_command(const BenchOptions& options);

/// `bench --probe`: the errors of the functions of a device.
Outcome probe_command(const BenchOptions& options, const Checkpoint& checkpoint);

/// `bench --exhaustive`.
Outcome exhaustive_command(const BenchOptions& options, const Checkpoint& checkpoint,
                           const Progress& progress);

}  // namespace shadefit
