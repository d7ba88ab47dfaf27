#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/verdicts/refit.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/table.hpp"

/// Helpers for the tables behind figures.
namespace shadefit {

/// Six digits: more than a picture shows, and free of rounding. Empty for an infinity or NaN.
Cell plotted(double value);

/// Equal steps from one end to the other, enough for a curve that looks smooth on a page.
inline constexpr int plot_steps = 200;

/// Even places from one end to the other, so many steps apart.
std::vector<double> even_places(double from, double to, int steps = plot_steps);

/// A curve of a figure, and the numbers of its column: its value at each place, NaN where it has none.
struct DrawnCurve {
  Curve curve;
  std::function<double(double place)> value;
};

std::vector<Curve> curves_of(const std::vector<DrawnCurve>& drawn);

/// The table of curves of the same places, without rows: the columns `first`, and one for each curve.
Table table_for(std::vector<std::string> first, const std::vector<DrawnCurve>& drawn);

/// Adds a row for each place: the cells `start`, the place, and the value of each curve.
void append_rows(Table& table, const std::vector<Cell>& start, const std::vector<DrawnCurve>& drawn,
                 const std::vector<double>& places);

/// The figure that a plot of these data is; of `family` as in `Figure`.
Figure figure_of(const Plot& plot, std::string_view family, const std::string& caption, const Table& data);

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
