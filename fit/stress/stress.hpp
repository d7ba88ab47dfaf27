#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "fit/stress/trial.hpp"
#include "fit/support/checkpoint.hpp"

/// The stress tests of all forms and fits.
namespace shadefit {

/// Random inputs per regime and format, and starts per family, of the command and its tables.
inline constexpr std::size_t stress_inputs = 1500, stress_starts = 10000;

/// Every form of every regime. `progress` gets the finished share.
std::vector<FormTrial> try_all_forms(std::size_t random, const Checkpoint& checkpoint,
                                     const std::function<void(double share)>& progress);

}  // namespace shadefit
