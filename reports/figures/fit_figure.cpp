#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit/support/user_error.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/rows/tables.hpp"

namespace shadefit {
namespace {

constexpr std::string_view file_name = "fit";
constexpr int panel_height = 260;

/// The error that the fit minimises.
double error_of(const Fit& fit, const CurvePoint& point) {
  return fit.metric.error == Error::relative ? point.relative_error.value_or(NAN) : point.error;
}

/// The part of the domain to draw. A narrow lobe is below a thousandth on most of it.
Domain shown_domain(const Fit& fit) {
  const double faint = fit.exponent ? std::pow(1e-3, 1 / *fit.exponent) : 0;
  const Domain& domain = fit.metric.domain;
  return {faint > 0.5 ? std::max(domain.lower, std::min(faint, domain.upper)) : domain.lower, domain.upper};
}

/// Whether the level and the contacts belong to the drawn error: a weight would scale them.
bool has_level(const Fit& fit) {
  return fit.level && fit.metric.weight.empty();
}

/// The curve over the cosine, and a row for each contact.
Table curve_table(const Fit& fit, const Family& family) {
  Table table{{"cosine", "target", "form", "error", "contact"}};
  const auto point_at = family.curve_at(setting_of(fit), fit.parameters);
  const Domain domain = shown_domain(fit);
  for (const double c : abscissae(domain.lower, domain.upper)) {
    const CurvePoint point = point_at({c, 1 - c});
    table.rows.push_back({plotted(c),
                          plotted(point.target),
                          plotted(point.form),
                          plotted_if_finite(error_of(fit, point)),
                          {}});
  }
  if (!has_level(fit)) return table;
  for (const AlternationPoint& contact : fit.alternation) {
    const double error = error_of(fit, point_at(contact.at));
    table.rows.push_back({plotted(contact.at.cos_theta), {}, {}, {}, plotted(error)});
  }
  return table;
}

/// "a = -5.5547, b = -6.9832"
std::string constants_text(const Fit& fit, const Family& family) {
  return equations(family.parameters, fit.parameters, [](double value) {
    return typeset(text(Number{value, 7}, Precision::report));
  });
}

Plot curve_plot(const Fit& fit, const Family& family, const Table& table) {
  const bool is_relative = fit.metric.error == Error::relative;
  const Domain domain = shown_domain(fit);
  const std::string range = fmt::format("set xrange [{:.9g}:{:.9g}]\n", domain.lower, domain.upper);
  const std::string at = fit.exponent ? fmt::format(", k = {}", *fit.exponent) : "";
  Panel curves{
      .title = for_gnuplot(fmt::format("{}{}: {}", to_text(family.form), at, constants_text(fit, family))),
      .y_label = fit.surface.is_exact() ? "weight f" : "value",
      .settings = range,
      .abscissa = "cosine",
      .curves = {{"target", "target: " + for_gnuplot(target_of(fit)), Look::target},
                 {"form", "form", Look::first}}};
  Panel errors{.x_label = "c, the cosine",
               .y_label = is_relative ? "relative error" : "form − target",
               .settings = range,
               .abscissa = "cosine",
               .curves = {{"error", is_relative ? "relative error" : "error", Look::second}}};
  if (has_level(fit)) {
    const std::string level = text(Number{*fit.level, 4}, Precision::report);
    errors.levels = {{level, "level " + level}, {"-" + level, ""}};
    errors.curves.push_back({"contact", "contacts", Look::first, false, true, false});
  }
  errors.settings += "set yrange " + range_around(table, errors.curves) + "\n";
  return {.name = std::string(file_name),
          .about = fmt::format("A fit of {}: {}.", family.id, name(fit.metric.norm)),
          .columns = 1,
          .panel_height = panel_height,
          .panels = {curves, errors}};
}

}  // namespace

Figure fit_figure(const Refit& refit) {
  const Family& family = *refit.family;
  const Fit& fit = refit.fits.front().fit;
  if (fit.status != Status::converged)
    throw UserError(fmt::format("--plot: no fit of {} converged", family.id));
  const Table table = curve_table(fit, family);
  const Plot plot = curve_plot(fit, family, table);
  return {plot.name, family.id, plot.about, table, write_script(plot)};
}

}  // namespace shadefit
