#pragma once

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"

namespace shadefit::bench {

/// "pareto-TARGET": error against time of the forms of a target in float, both axes logarithmic, data in the
/// first cache, each form at its fastest width. A line joins the front. Every mark has its name. Needs a form
/// with an error.
Figure pareto_figure(const Trade& trade, const TimedTarget& target);

/// Whether a target has the data for its figure.
bool has_pareto_figure(const Trade& trade, const TimedTarget& target);

}  // namespace shadefit::bench
