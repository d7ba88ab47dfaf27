#pragma once

#include <functional>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/tradeoff/measure.hpp"

namespace shadefit::bench {

/// The places for the errors of a target: the floats of each argument, the same number for all. They are
/// cosines, then the codes if the target reads them, or the axes of normals.
using Grid = std::vector<std::vector<float>>;

/// A dense grid over the domain of a target, ends included.
Grid grid_of(const forms::Target& target);

/// The target's own formula in double at the places of a grid.
std::vector<double> truth_at(const Grid& grid, const forms::Catalogue& catalogue,
                             const forms::Target& target);

/// The largest absolute error of every requested form, for each set of constants, degree and precision, in
/// SSE2, over a dense grid including its ends. The reference is the target's formula in double. `between` may
/// end the work by throwing.
std::vector<FormError> grid_errors(const forms::Catalogue& catalogue, const std::vector<std::string>& targets,
                                   const std::function<void()>& between);

}  // namespace shadefit::bench
