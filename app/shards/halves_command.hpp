#pragma once

#include "app/options/bench_options.hpp"
#include "app/options/outcome.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// `bench --exhaustive FORM|all --device vulkan --half`: every half in [0, 1] through a form, or through all
/// of one cosine, on a graphics device. Writes a row for each to errors-half.csv. The outcome is 1 if a
/// result is beyond its bound. Throws UserError if the device has no half.
Outcome halves_command(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress);

}  // namespace shadefit
