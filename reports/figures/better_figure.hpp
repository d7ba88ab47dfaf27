#pragma once

#include "fit/better/better.hpp"
#include "reports/figures/figure.hpp"

namespace shadefit {

/// The figure of a comparison: the errors of the published curves, three at most, and of the best curve that
/// beats one of them, over the domain. On a surface the errors are those of the reflectance F.
Figure better_figure(const Comparison& comparison);

}  // namespace shadefit
