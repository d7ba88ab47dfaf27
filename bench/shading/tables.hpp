#pragma once

#include <string>

#include "bench/shading/measure.hpp"
#include "reports/figures/figure.hpp"
#include "reports/table/table.hpp"
#include "reports/table/writers.hpp"

/// A measurement for people and for programs.
namespace shadefit::shade {

/// `way,tolerance,form,ns_per_sample,max_error,mean_error,max_codes,mean_codes`: the ways, then the
/// sweep, then the ways on another device. The columns of `shade.csv`; the last is `device`.
Table shade_table(const Measurement& measurement);

/// The ways and a summary, on a terminal.
std::string shade_text(const Measurement& measurement, const Terminal& terminal = {});

/// A line for each plan that exceeds its promise.
std::string broken_lines(const Measurement& measurement);

/// "shade": error against time of the plans for all tolerances and of the published constants, both
/// logarithmic, the reference's time beside them.
Figure shade_figure(const Measurement& measurement);

}  // namespace shadefit::shade
