#pragma once

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"

namespace shadefit::bench {

/// "pareto-TARGET": error against time of every form of a target, both logarithmic, data in the first cache,
/// each at its fastest width; those on the front are joined and named. Needs a form with an error.
Figure pareto_figure(const Trade& trade, const TimedTarget& target);

/// Whether a target has the data for its figure.
bool has_pareto_figure(const Trade& trade, const TimedTarget& target);

}  // namespace shadefit::bench
