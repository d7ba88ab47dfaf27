#pragma once

#include <string>

#include "app/options/bench_options.hpp"
#include "bench/forms/catalogue.hpp"

namespace shadefit {

/// `bench --exhaustive all`: every form of one cosine with every set of its constants, on the CPU, on a
/// device, or on all devices. The forms of one target go together, on all devices, because they share its
/// truth. Writes a table for each device.
Outcome sweep_every_form(const BenchOptions& options, const forms::Catalogue& catalogue,
                         const std::string& version, const Checkpoint& checkpoint, const Progress& progress);

}  // namespace shadefit
