#include "bench/tradeoff/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/writers.hpp"

namespace shadefit::bench {
namespace {

/// A time or an error: three digits, because times are repeatable to about a percent.
Cell measured(const std::optional<double>& value) {
  return value ? Cell(Number{*value, 3}) : Cell{};
}

std::string how_it_was_measured(const Trade& trade) {
  const Machine& machine = trade.machine;
  if (machine.is_graphics())
    return fmt::format(
        "{}, driver {}, on {}; clock: {}. Each form is the GLSL that `emit` writes, in a compute shader. A time is\n"
        "the mean of a long row of evaluations on the whole device, and of such means the median of {} rounds. Each round visits\n"
        "every form once; `spread` is the interquartile range. `MADs`: in the time of a multiply-add in float. The loop's own time is\n"
        "subtracted, and four evaluations of a thread do not wait for each other.\n"
        "Errors are the largest of this device, on a grid, against the target in double.\n\n",
        machine.device, machine.driver, machine.cpu, machine.clock, trade.rounds);
  return fmt::format(
      "{}, compiled by {}. Each form is the C code that `emit` writes, in float, one number at a time.\n"
      "The times are medians of {} rounds, each of which visits every form once, on one core, with the data in L1;\n"
      "`spread` is the interquartile range. `MADs`: in the time of a multiply-add.\n"
      "Errors are {}. Times are this machine's, of this day.\n\n",
      machine.cpu, machine.compiler, trade.rounds,
      trade.shows_all_sets ? "those of exact arithmetic"
                           : "the largest in float on a grid, against the target in double");
}

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
  const auto [least, largest] = std::ranges::minmax_element(forms, {}, &TimedForm::max_abs_error);
  for (const TimedForm& timed : forms) {
    const std::string name = trade.shows_all_sets ? timed.label : full_id(timed);
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
          logarithmic_range(*least->max_abs_error, *largest->max_abs_error, 0.1), names),
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

Table bench_table(const Trade& trade) {
  const Machine& machine = trade.machine;
  Table table{{"target", "form", "constants", "exp2_degree", "precision", "ns_per_element", "spread",
               "max_abs_error", "multiply_adds", "cpu", "compiler", "device", "driver", "clock"}};
  for (const TimedForm& timed : trade.forms)
    table.rows.push_back({timed.target, timed.form, timed.constants, static_cast<long>(timed.exp2_degree),
                          word(name(timed.precision)), measured(timed.ns.median), measured(timed.ns.width),
                          measured(timed.max_abs_error), measured(timed.multiply_adds), machine.cpu,
                          machine.compiler, machine.device, machine.driver, machine.clock});
  return table;
}

Table times_table(const Trade& trade, const std::string& target) {
  Table table{{"form", "precision", "max abs error", "ns", "spread", "MADs", "unbeaten"}};
  for (const TimedForm& timed : shown_forms(trade, target))
    table.rows.push_back({OthersText(timed.label), word(name(timed.precision)), measured(timed.max_abs_error),
                          measured(timed.ns.median), measured(timed.ns.width), measured(timed.multiply_adds),
                          std::string(timed.is_unbeaten ? "yes" : "")});
  return table;
}

std::vector<Figure> bench_figures(const Trade& trade) {
  std::vector<Figure> figures;
  for (const TimedTarget& target : trade.targets) {
    const std::vector<TimedForm> forms = drawable_forms(trade, target.id);
    if (!forms.empty()) figures.push_back(pareto_figure(trade, target, forms));
  }
  return figures;
}

std::vector<File> bench_files(const Trade& trade, const std::vector<Figure>& figures) {
  std::string text = "# Run time against error\n\n" + how_it_was_measured(trade);
  text += markdown_block(times_table(trade, ""));
  for (const TimedTarget& target : trade.targets) {
    text +=
        fmt::format("## {}\n\n{}", for_markdown(target.title), markdown_block(times_table(trade, target.id)));
    const auto figure = std::ranges::find(figures, "pareto-" + target.id, &Figure::name);
    if (figure != figures.end())
      text += fmt::format("![{0}](plots/{1}.svg)\n\n{0}\n\n", for_markdown(figure->caption), figure->name);
  }
  text.pop_back();  // sections end in an empty line, the file does not
  return {{"bench.md", text}, {"bench.csv", write_csv(bench_table(trade), Precision::report)}};
}

}  // namespace shadefit::bench
