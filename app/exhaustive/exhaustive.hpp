#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "app/options/bench_options.hpp"
#include "reports/table/table.hpp"

/// The parts of `bench --exhaustive`.
namespace shadefit {

/// `bench --exhaustive FORM|all --device vulkan --half`: every half in [0, 1] through a form, or through all
/// of one cosine, on a graphics device. Writes a row for each to errors-half.csv. The outcome is 1 if a
/// result is beyond its bound. Throws UserError if the device has no half.
Outcome halves_command(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress);

/// How many results are how far from the truth. `ulps` counts them: [0] those that are equal, [i] those that
/// are 2^(i-1) to 2^i - 1 ulps away. A share is one of `count` results. `numbers` heads the counts: "floats".
Table ulps_table(std::span<const std::uint64_t> ulps, std::uint64_t count, const std::string& numbers);

}  // namespace shadefit
