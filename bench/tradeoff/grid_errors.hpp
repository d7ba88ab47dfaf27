#pragma once

#include <functional>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/tradeoff/measure.hpp"

namespace shadefit::bench {

/// The largest absolute error of every requested form, for each set of constants, degree and precision, in
/// SSE2, over a dense grid including its ends. The reference is the target's formula in double. `between` may
/// end the work by throwing.
std::vector<FormError> grid_errors(const forms::Catalogue& catalogue, const std::vector<std::string>& targets,
                                   const std::function<void()>& between);

}  // namespace shadefit::bench
