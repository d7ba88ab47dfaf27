#pragma once

#include <stdexcept>

/// The benchmarks of shadefit, by file. See bench/README.md.
namespace shadefit::bench {

/// Ends the run, with exit code 1, if what is timed went wrong.
inline void require(bool is_well, const char* what) {
  if (!is_well) throw std::runtime_error(what);
}

/// Whole fits of families, from nothing: by least squares and by their largest error.
void register_fits();

/// The ledger, and each of its claims.
void register_claims();

/// Proofs: certificates and their check.
void register_proofs();

/// The Fresnel pair as a study beside its family: the rate of its sums, and its fit from text.
void register_studies();

/// The command as a process: its time and its memory.
void register_process();

}  // namespace shadefit::bench
