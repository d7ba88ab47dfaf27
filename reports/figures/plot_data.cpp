#include "reports/figures/plot_data.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "fit/catalogue/family.hpp"

namespace shadefit {

Cell plotted(double value) {
  constexpr int digits = 6;
  return std::isfinite(value) ? Cell(Number{value, digits}) : Cell();
}

std::vector<double> even_places(double from, double to, int steps) {
  std::vector<double> places;
  for (int i = 0; i <= steps; ++i) places.push_back(from + (to - from) * i / steps);
  return places;
}

std::vector<Curve> curves_of(const std::vector<DrawnCurve>& drawn) {
  std::vector<Curve> curves;
  for (const DrawnCurve& of : drawn) curves.push_back(of.curve);
  return curves;
}

Table table_for(std::vector<std::string> first, const std::vector<DrawnCurve>& drawn) {
  for (const DrawnCurve& of : drawn) first.push_back(of.curve.column);
  return {std::move(first)};
}

void append_rows(Table& table, const std::vector<Cell>& start, const std::vector<DrawnCurve>& drawn,
                 const std::vector<double>& places) {
  for (const double place : places) {
    auto& row = table.rows.emplace_back(start);
    row.push_back(plotted(place));
    for (const DrawnCurve& of : drawn) row.push_back(plotted(of.value(place)));
  }
}

Figure figure_of(const Plot& plot, std::string_view family, const std::string& caption, const Table& data) {
  return {plot.name, family, caption, data, write_script(plot)};
}

Cosine<double> cosine_of_degrees(double degrees) {
  constexpr double radian = std::numbers::pi / 180;
  // The sine of the complement gives the cosine 0 at 90 degrees; the half angle avoids cancellation in 1 - c.
  const double half_sine = std::sin(degrees / 2 * radian);
  return {std::sin((90 - degrees) * radian), 2 * half_sine * half_sine};
}

double degrees_of(const Cosine<double>& cosine) {
  return 2 * std::asin(std::sqrt(cosine.one_minus_cos / 2)) * 180 / std::numbers::pi;
}

std::string printed(std::string_view id) {
  if (const Published* found = find_published(id)) return found->printed;
  throw std::logic_error("no constant was published as " + std::string(id));
}

std::string typeset(std::string_view decimal) {
  return decimal.starts_with('-') ? "−" + std::string(decimal.substr(1)) : std::string(decimal);
}

const Fit* fit_at(const Refit& refit, Measure measure, double exponent) {
  for (const FitReport& report : refit.fits) {
    const Fit& fit = report.fit;
    if (fit.metric == Metric{.measure = measure} && fit.exponent == exponent) return &fit;
  }
  return nullptr;
}

Table best_parameter_table(const Refit& refit) {
  Table table{{"exponent"}};
  for (const Measure measure : measures) table.columns.emplace_back(name(measure));
  for (const FitReport& report : refit.fits) {
    if (report.fit.metric != Metric{.measure = measures.front()}) continue;
    const double exponent = *report.fit.exponent;
    auto& row = table.rows.emplace_back(std::vector<Cell>{plotted(exponent)});
    for (const Measure measure : measures) {
      const Fit* fit = fit_at(refit, measure, exponent);
      row.push_back(fit != nullptr ? plotted(fit->parameters.front()) : Cell());
    }
  }
  return table;
}

}  // namespace shadefit
