#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/verdicts/refit.hpp"
#include "reports/io/table.hpp"

/// Helpers for the tables behind figures.
namespace shadefit {

/// Six digits: more than a picture shows, and free of rounding.
Cell plotted(double value);

/// The same; empty for an infinity or NaN.
Cell plotted_if_finite(double value);

/// Equal steps from one end to the other, enough for a curve that looks smooth on a page.
inline constexpr int plot_steps = 200;

/// Twice as many even places from one end to the other, for a figure of one panel.
std::vector<double> abscissae(double from, double to);

/// The cosine of an angle in degrees, 0 to 90, both it and its distance from 1 to full precision.
Cosine<double> cosine_of_degrees(double degrees);

/// An angle in degrees, from its cosine.
double degrees_of(const Cosine<double>& cosine);

/// The digits of a published constant as printed, by its id. Throws std::logic_error for an unknown id.
std::string printed(std::string_view id);

/// A number for people and gnuplot's labels: a true minus sign.
std::string typeset(std::string_view decimal);

/// The fit of the whole domain under a measure at that exponent, or null.
const Fit* fit_at(const Refit& refit, Measure measure, double exponent);

/// A family's only parameter by exponent, one column per measure: `exponent`, `cosine`, `angle`, ..
Table best_parameter_table(const Refit& refit);

}  // namespace shadefit
