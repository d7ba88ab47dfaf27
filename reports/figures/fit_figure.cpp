#include "reports/figures/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
Table curve_table(const Fit& fit, const FittableFamily& family) {
  Table table{{"cosine", "target", "form", "error", "contact"}};
  const auto point_at = [&](const Cosine<double>& at) {
    return family.point(setting_of(fit), fit.parameters, at);
  };
  const Domain domain = shown_domain(fit);
  constexpr int steps = 2 * plot_steps;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double c = domain.lower + share * (domain.upper - domain.lower);
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
std::string constants_text(const Fit& fit, const FittableFamily& family) {
  return equations(family.parameters, fit.parameters, [](double value) {
    return typeset(text(Number{value, 7}, Precision::report));
  });
}

Plot curve_plot(const Fit& fit, const FittableFamily& family, const Table& table) {
  const bool is_relative = fit.metric.error == Error::relative;
  const Domain domain = shown_domain(fit);
  const std::string range = fmt::format("set xrange [{:.9g}:{:.9g}]\n", domain.lower, domain.upper);
  const std::string at = fit.exponent ? fmt::format(", k = {}", *fit.exponent) : "";
  Panel curves{
      .title = for_gnuplot(fmt::format("{}{}: {}", to_text(family.form()), at, constants_text(fit, family))),
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
          .about = fmt::format("A fit of {}: {}.", family.info.id, name(fit.metric.norm)),
          .columns = 1,
          .panel_height = panel_height,
          .panels = {curves, errors}};
}

/// The curves of a sweep: of the least, the middle and the largest exponent.
std::vector<const Fit*> drawn_of(std::vector<const Fit*> fits) {
  std::ranges::sort(fits, [](const Fit* a, const Fit* b) { return *a->exponent < *b->exponent; });
  if (fits.size() == 2) return fits;
  return {fits.front(), fits[fits.size() / 2], fits.back()};
}

/// Over k (1 - c) the lobes of all exponents have nearly the same width. At 8 they are below a thousandth.
constexpr double farthest_scaled = 8;

/// Appends, for each drawn fit, its target, form and error over k (1 - c).
void add_curves(Table& table, const std::vector<const Fit*>& drawn, const FittableFamily& family) {
  const std::size_t before = table.columns.size();
  table.columns.emplace_back("scaled");
  for (std::size_t i = 1; i <= drawn.size(); ++i)
    for (const char* column : {"target", "form", "error"})
      table.columns.push_back(fmt::format("{}_{}", column, i));
  for (auto& row : table.rows) row.resize(table.columns.size());
  for (int step = 0; step <= plot_steps; ++step) {
    const double scaled = farthest_scaled * step / plot_steps;
    auto& row = table.rows.emplace_back(before);
    row.push_back(plotted(scaled));
    for (const Fit* fit : drawn) {
      const double from_peak = scaled / *fit->exponent;
      const Domain& domain = fit->metric.domain;
      if (1 - from_peak < domain.lower || 1 - from_peak > domain.upper) {
        row.resize(row.size() + 3);
        continue;
      }
      const CurvePoint point =
          family.point(setting_of(*fit), fit->parameters, Cosine<double>{1 - from_peak, from_peak});
      for (const double value : {point.target, point.form, error_of(*fit, point)})
        row.push_back(plotted_if_finite(value));
    }
  }
}

/// Rows of one fit each, then rows of one place each.
Table sweep_table(const std::vector<const Fit*>& fits, const FittableFamily& family) {
  Table table{{"exponent"}};
  for (const std::string_view parameter : family.parameters) table.columns.emplace_back(parameter);
  table.columns.insert(table.columns.end(), {"max_abs_error", "rms_error"});
  for (const Fit* fit : fits) {
    auto& row = table.rows.emplace_back(std::vector<Cell>{plotted(*fit->exponent)});
    for (const double parameter : fit->parameters) row.push_back(plotted(parameter));
    row.insert(row.end(), {plotted(fit->max_abs_error.magnitude), plotted(fit->rms_error)});
  }
  add_curves(table, drawn_of(fits), family);
  return table;
}

/// Targets and forms above, errors below.
std::array<Panel, 2> curve_panels(const std::vector<const Fit*>& drawn) {
  const bool is_relative = drawn.front()->metric.error == Error::relative;
  Panel curves{.title = "Curves of three exponents",
               .y_label = "value",
               .settings = "set yrange [0:*]\n",  // a lobe is never negative
               .abscissa = "scaled"};
  if (drawn.size() == 2) curves.title = "Curves of two exponents";
  Panel errors{.x_label = "k (1 − c)",
               .y_label = is_relative ? "relative error" : "form − target",
               .abscissa = "scaled"};
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::string label = fmt::format("k = {}", *drawn[i]->exponent);
    curves.curves.push_back({fmt::format("target_{}", i + 1), "target", Look::target});
    curves.curves.push_back({fmt::format("form_{}", i + 1), label, curve_looks.at(i)});
    errors.curves.push_back({fmt::format("error_{}", i + 1), label, curve_looks.at(i)});
  }
  return {curves, errors};
}

Plot sweep_plot(const std::vector<const Fit*>& fits, const FittableFamily& family) {
  const std::vector<const Fit*> drawn = drawn_of(fits);
  // Over more than a decade, a logarithmic axis shows both ends.
  const std::string scale = *drawn.back()->exponent > 10 * *drawn.front()->exponent ? "set logscale x\n" : "";
  Panel parameters{.title = for_gnuplot(to_text(family.form())),
                   .y_label = "parameter",
                   .settings = scale,
                   .abscissa = "exponent"};
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    const std::string name(family.parameters[i]);
    parameters.curves.push_back({name, name, curve_looks.at(i), false, true});
  }
  const Panel errors{.x_label = "k, the exponent",
                     .y_label = "error",
                     .settings = scale + "set logscale y\nset format y '10^{%T}'\n",
                     .abscissa = "exponent",
                     .curves = {{"max_abs_error", "largest error", Look::second, false, true},
                                {"rms_error", "rms error", Look::third, false, true}}};
  const auto [curves, curve_errors] = curve_panels(drawn);
  return {.name = std::string(file_name),
          .about = fmt::format("Fits of {}: {}.", family.info.id, name(fits.front()->metric.norm)),
          .columns = 2,
          .panel_height = panel_height,
          .panels = {parameters, curves, errors, curve_errors}};
}

}  // namespace

Figure fit_figure(const Refit& refit) {
  const FittableFamily& family = *refit.family;
  std::vector<const Fit*> fits;
  for (const FitReport& report : refit.fits) {
    if (report.fit.status == Status::converged) fits.push_back(&report.fit);
  }
  if (fits.empty()) throw UserError(fmt::format("--plot: no fit of {} converged", family.info.id));
  const bool is_sweep = fits.size() > 1;
  const Table table = is_sweep ? sweep_table(fits, family) : curve_table(*fits.front(), family);
  const Plot plot = is_sweep ? sweep_plot(fits, family) : curve_plot(*fits.front(), family, table);
  return {plot.name, family.info.id, plot.about, table, write_script(plot)};
}

}  // namespace shadefit
