#pragma once

#include <string>
#include <vector>

#include "fit/support/checkpoint.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/files.hpp"

namespace shadefit {

/// The files of the figures, and what is said of them.
struct DrawnFigures {
  std::vector<File> files;    ///< data, scripts and the pictures that were drawn
  std::vector<File> missing;  ///< pictures that were not drawn: old ones must not remain next to new data
  std::string out, err;       ///< for standard output and standard error
};

/// Draws the figures and keeps in `figures` those that have a picture. It only names the directory `out` and
/// writes nothing there.
DrawnFigures draw_figures(std::vector<Figure>& figures, const std::string& out, const Checkpoint& checkpoint);

/// Throws UserError unless the name of a picture ends with .svg and its folder is there, or
/// where gnuplot is missing.
void require_picture(const std::string& file);

}  // namespace shadefit
