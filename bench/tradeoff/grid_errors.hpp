#pragma once

#include <functional>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/tradeoff/measure.hpp"

namespace shadefit::bench {

/// The largest absolute error of every form that is wanted, each set of constants, degree and precision, in
/// SSE2, over a dense grid with its ends; the truth is the target's own formula in double. `between` may end
/// it.
std::vector<FormError> grid_errors(const forms::Catalogue& catalogue, const std::vector<std::string>& targets,
                                   const std::function<void()>& between);

}  // namespace shadefit::bench
