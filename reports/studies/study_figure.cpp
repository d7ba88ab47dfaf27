#include "reports/studies/study_figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/plot_data.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/gnuplot_text.hpp"
#include "reports/studies/study_comparison.hpp"

namespace shadefit {
namespace {

constexpr std::array looks{Look::first, Look::second, Look::third, Look::fourth};
constexpr int panel_height = 260;

/// A formula at a place of the only variable.
double value_at(const ReadStudy& study, const Symbolic& formula, const std::vector<double>& parameters,
                double x) {
  return evaluate<double>(formula, [&](const std::string& name) {
    if (name == study.axes.front().variable) return x;
    std::size_t i = 0;
    while (study.parameters[i] != name) ++i;
    return parameters[i];
  });
}

void require_one_variable(const std::string& what, std::size_t variables) {
  if (variables != 1) throw UserError(fmt::format("--plot draws one variable: {} has {}", what, variables));
}

Cell plotted_if_finite(double value) {
  return std::isfinite(value) ? plotted(value) : Cell();
}

/// Even places from one end to the other.
std::vector<double> abscissae(const StudyAxis& axis) {
  std::vector<double> places;
  constexpr int steps = 2 * plot_steps;
  for (int i = 0; i <= steps; ++i) places.push_back(axis.lower + (axis.upper - axis.lower) * i / steps);
  return places;
}

std::string range_of(const StudyAxis& axis) {
  return fmt::format("set xrange [{:.9g}:{:.9g}]\n", axis.lower, axis.upper);
}

/// "g = 0.5", or the constants of the only fit.
std::string label_of(const FittedStudy& study) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : study.asked().given) parts.push_back(name + " = " + value);
  for (std::size_t i = 0; parts.empty() && i < study.fit.names.size(); ++i)
    parts.push_back(study.fit.names[i] + " = " + text(Number{study.fit.parameters[i], 7}, Precision::report));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Figure study_figure(const std::vector<FittedStudy>& studies) {
  std::vector<const FittedStudy*> shown;
  for (const FittedStudy& study : studies) {
    if (study.fit.status == Status::converged && shown.size() < looks.size()) shown.push_back(&study);
  }
  require_one_variable("the study", studies.front().read.axes.size());
  if (shown.empty()) throw UserError("--plot has nothing to draw: no fit converged");
  const StudyAxis& axis = shown.front()->read.axes.front();
  Table table{{axis.variable}, {}};
  Panel curves{.title = gnuplot_unmarked(study_headline(*shown.front())),
               .y_label = "value",
               .settings = range_of(axis),
               .abscissa = axis.variable,
               .curves = {}};
  Panel errors{.x_label = gnuplot_unmarked(axis.variable),
               .y_label = "form − target",
               .settings = range_of(axis),
               .abscissa = axis.variable,
               .curves = {}};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    for (const char* column : {"target", "form", "error"})
      table.columns.push_back(fmt::format("{}_{}", column, i + 1));
    curves.curves.push_back({fmt::format("target_{}", i + 1), "target", Look::target});
    const std::string label = gnuplot_unmarked(label_of(*shown[i]));
    curves.curves.push_back({fmt::format("form_{}", i + 1), label, looks.at(i)});
    errors.curves.push_back({fmt::format("error_{}", i + 1), label, looks.at(i)});
  }
  for (const double x : abscissae(axis)) {
    std::vector<Cell> row{plotted(x)};
    for (const FittedStudy* study : shown) {
      const double target = value_at(study->read, study->read.target, study->fit.parameters, x);
      const double form = value_at(study->read, study->read.form, study->fit.parameters, x);
      for (const double value : {target, form, form - target}) row.push_back(plotted_if_finite(value));
    }
    table.rows.push_back(row);
  }
  errors.settings += "set yrange " + range_around(table, errors.curves) + "\n";
  const Plot plot{.name = "fit",
                  .about = "A fit, and its error.",
                  .columns = 1,
                  .panel_height = panel_height,
                  .panels = {curves, errors}};
  return {plot.name, "", plot.about, table, write_script(plot)};
}

Figure better_study_figure(const StudyComparison& comparison) {
  require_one_variable("the study", comparison.variables.size());
  std::vector<const StudyContender*> shown;
  const StudyContender* best = nullptr;
  for (const StudyContender& contender : comparison.contenders) {
    const bool is_published = contender.published != nullptr;
    if (is_published && shown.size() + 1 < looks.size()) shown.push_back(&contender);
    const bool is_candidate = !is_published && (!contender.beats.empty() || shown.empty());
    if (is_candidate && (best == nullptr || contender.max_error.magnitude < best->max_error.magnitude))
      best = &contender;
  }
  if (best != nullptr) shown.push_back(best);
  const std::string& variable = comparison.variables.front();
  Table table{{variable}, {}};
  Panel panel{.title = gnuplot_unmarked(comparison.study.target),
              .x_label = gnuplot_unmarked(variable),
              .y_label = curve_in_words(comparison.error),
              .abscissa = variable,
              .curves = {}};
  std::vector<ReadStudy> read;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    read.push_back(formulas_of(comparison, *shown[i]));
    const std::string column = fmt::format("error_{}", i + 1);
    table.columns.push_back(column);
    panel.curves.push_back(
        {column,
         gnuplot_unmarked(fmt::format(
             "{}: {}", shown[i]->form,
             shown[i]->published != nullptr ? short_source(shown[i]->origin) : "best, " + shown[i]->origin)),
         looks.at(i)});
  }
  const StudyAxis& axis = read.front().axes.front();
  for (const double x : abscissae(axis)) {
    std::vector<Cell> row{plotted(x)};
    for (std::size_t i = 0; i < shown.size(); ++i)
      row.push_back(
          plotted_if_finite(value_at(read[i], weighted_error_of(read[i]).form, shown[i]->values, x)));
    table.rows.push_back(row);
  }
  panel.settings = range_of(axis) + "set yrange " + range_around(table, panel.curves) + "\n";
  const Plot plot{.name = "better",
                  .about = fmt::format("Errors of the published constants and of the best curve, for {}.",
                                       comparison.study.target),
                  .columns = 1,
                  .panel_height = panel_height + 100,
                  .panels = {panel}};
  return {plot.name, "", plot.about, table, write_script(plot)};
}

}  // namespace shadefit
