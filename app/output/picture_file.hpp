#pragma once

#include <functional>
#include <string>

#include "fit/support/checkpoint.hpp"
#include "reports/figures/figure.hpp"

namespace shadefit {

/// Throws UserError unless the name of a picture ends with .svg, .pdf or .png, or where gnuplot is missing.
void require_picture(const std::string& file);

/// Draws the figure. The returned call writes it to `file`. Throws UserError where gnuplot fails or the file
/// cannot be written.
std::function<void()> draw_picture(const Figure& figure, const std::string& file, bool force,
                                   const Checkpoint& checkpoint);

}  // namespace shadefit
