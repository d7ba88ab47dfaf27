#pragma once

#include <string>
#include <vector>

#include "app/options/bench_options.hpp"
#include "bench/exhaustive/sweep.hpp"
#include "bench/forms/catalogue.hpp"
#include "reports/io/files.hpp"

namespace shadefit {

/// `bench --exhaustive all`: every form of one cosine with every set of its constants, on the CPU, on a
/// device, or on all devices. The forms of one target go together, on all devices, because they share its
/// truth. Writes a table for each device; with --shard only the parts of the sweeps.
Outcome sweep_every_form(const BenchOptions& options, const forms::Catalogue& catalogue,
                         const std::string& version, const Checkpoint& checkpoint, const Progress& progress);

/// The table of whole sweeps on one device or on the CPU: errors.csv, in the order of the catalogue.
File errors_file(const forms::Catalogue& catalogue, const std::vector<bench::Sweep>& sweeps);

}  // namespace shadefit
