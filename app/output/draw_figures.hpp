#pragma once

#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"

namespace shadefit {

/// What a command says of its plots, on standard output and standard error.
struct PlotsNews {
  std::string out, err;
};

/// What there is to be written of figures.
struct DrawnFigures {
  std::vector<File> files;    ///< data, scripts and the pictures that were drawn
  std::vector<File> missing;  ///< pictures that were not: none of an older run may stand beside new data
  PlotsNews news;
};

/// Draws the figures, for a directory `out` that is only named, and leaves in `figures` those that there is a
/// picture of.
DrawnFigures draw_figures(std::vector<Figure>& figures, const std::string& out, const Checkpoint& checkpoint);

}  // namespace shadefit
