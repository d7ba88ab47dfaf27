#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/tradeoff/report.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"

namespace shadefit::bench {
namespace {

/// "[low:high]" of a logarithmic axis around these numbers, with a free share of it at the upper end.
std::string logarithmic_range(double low, double high, double free_above) {
  const double span = std::max(high / low, 10.0);
  return fmt::format("[{:.4g}:{:.4g}]", low * std::pow(span, -0.06), high * std::pow(span, free_above));
}

/// The forms that have a place on logarithmic axes, in float, as shaders compute.
std::vector<TimedForm> drawable_forms(const Trade& trade, const std::string& target) {
  std::vector<TimedForm> forms = shown_forms(trade, target);
  std::erase_if(forms, [](const TimedForm& timed) {
    return timed.precision != ShaderPrecision::float32 || !(timed.max_abs_error > 0.0) ||
           !std::isfinite(*timed.max_abs_error) || !(timed.ns.median > 0);
  });
  mark_unbeaten(forms);
  return forms;
}

Figure pareto_figure(const Trade& trade, const TimedTarget& target, const std::vector<TimedForm>& forms) {
  Figure figure{
      .name = "pareto-" + target.id,
      .family = "",
      .caption = fmt::format(
          "Error against time of {}: each form in float. No form is both faster and more accurate than "
          "one on the line.",
          target.title),
      .data = {{"ns", "front", "form", "name"}, {}},
      .script = ""};
  std::string names;
  double least = *forms.front().max_abs_error, largest = least;
  for (const TimedForm& timed : forms) {
    const std::string name = trade.shows_all_sets ? timed.label : full_id(timed);
    least = std::min(least, *timed.max_abs_error);
    largest = std::max(largest, *timed.max_abs_error);
    const Cell error = Number{*timed.max_abs_error, 4};
    figure.data.rows.push_back({Number{timed.ns.median, 4}, timed.is_unbeaten ? error : Cell{},
                                timed.is_unbeaten ? Cell{} : error, OthersText(name)});
    if (timed.is_unbeaten)
      names +=
          fmt::format("set label {} at first {:.4g}, first {:.4g} offset 0.8,0.6 front textcolor '#101010'\n",
                      gnuplot_quoted(for_gnuplot(name)), timed.ns.median, *timed.max_abs_error);
  }
  const bool is_graphics = trade.machine.is_graphics();
  Panel panel{
      .title = fmt::format("{}, on {}", for_gnuplot(target.title),
                           for_gnuplot(is_graphics ? trade.machine.device : trade.machine.cpu)),
      .x_label = is_graphics ? "time of an evaluation in ns, on the whole device"
                             : "time of an element in ns, one number at a time, one core",
      .y_label = "largest absolute error",
      .settings = fmt::format(
          "set logscale x 2\nset logscale y\nset format y '10^{{%L}}'\nset xrange {}\nset yrange {}\n{}",
          logarithmic_range(forms.front().ns.median, forms.back().ns.median, 0.3),
          logarithmic_range(least, largest, 0.1), names),
      .abscissa = "ns",
      .curves = {{.column = "front", .label = "unbeaten", .look = Look::first, .has_points = true}}};
  // gnuplot warns of a curve without data.
  if (!std::ranges::all_of(forms, &TimedForm::is_unbeaten))
    panel.curves.push_back(
        {.column = "form", .label = "other forms", .look = Look::second, .is_joined = false});
  figure.script = write_script({.name = figure.name,
                                .about = "Run time against error: " + target.id,
                                .columns = 1,
                                .panel_height = 470,
                                .panels = {panel}});
  return figure;
}

}  // namespace

std::vector<Figure> bench_figures(const Trade& trade) {
  std::vector<Figure> figures;
  for (const TimedTarget& target : trade.targets) {
    const std::vector<TimedForm> forms = drawable_forms(trade, target.id);
    if (!forms.empty()) figures.push_back(pareto_figure(trade, target, forms));
  }
  return figures;
}

}  // namespace shadefit::bench
