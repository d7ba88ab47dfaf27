#pragma once

#include <vector>

#include "fit/run/results.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"

/// The figures of a run.
namespace shadefit {

/// The figures that the results allow: those of each refitted family whose fits all converged.
std::vector<Figure> make_figures(const Results& results);

/// plots/NAME.csv and plots/NAME.gnuplot of each.
std::vector<File> plot_files(const std::vector<Figure>& figures);

}  // namespace shadefit
