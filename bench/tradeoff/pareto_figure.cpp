#include "bench/tradeoff/pareto_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "bench/tradeoff/labels.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/gnuplot_text.hpp"

namespace shadefit::bench {
namespace {

/// Pixels of the area between the axes: as wide as a plot of one column is, see
/// reports/figures/plot_script.cpp.
constexpr Pixel area{798, 470};

/// A logarithmic axis.
struct Axis {
  double low, high;
  double share(double value) const { return std::log(value / low) / std::log(high / low); }
  double at(double share) const { return low * std::pow(high / low, share); }
};

/// Round some numbers, with a share of the whole left free at either end.
Axis axis_around(const std::vector<double>& values, double free_below, double free_above) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double decades = std::max(std::log10(*high / *low), 0.5);
  return {*low * std::pow(10, -free_below * decades), *high * std::pow(10, free_above * decades)};
}

/// What is drawn: the front first, in its order, so that a line joins it.
struct Drawn {
  std::vector<TimedForm> front, others;

  std::vector<TimedForm> all() const {
    std::vector<TimedForm> rows = front;
    rows.insert(rows.end(), others.begin(), others.end());
    return rows;
  }
};

/// A logarithmic axis has no place for an error of 0.
bool is_drawable(const TimedForm& timed) {
  return *timed.max_abs_error > 0 && std::isfinite(*timed.max_abs_error) && timed.ns.median > 0;
}

/// The target's own formula in a scalar loop, which the fastest widths leave out.
bool is_scalar_reference(const TimedForm& timed, const std::string& target) {
  return timed.target == target && timed.is_reference && timed.width == forms::Width::scalar &&
         timed.place == Place::first_cache && timed.max_abs_error.has_value();
}

bool has(const std::vector<TimedForm>& rows, const TimedForm& timed) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const TimedForm& other) { return is_same_way(other, timed); });
}

Drawn drawn_of(const Trade& trade, const std::string& target) {
  Drawn drawn{front_of_target(trade, target), fastest_of(trade, target)};
  std::erase_if(drawn.others, [&](const TimedForm& timed) { return has(drawn.front, timed); });
  for (const TimedForm& timed : trade.forms) {
    if (is_scalar_reference(timed, target) && !has(drawn.front, timed) && !has(drawn.others, timed))
      drawn.others.push_back(timed);
  }
  std::erase_if(drawn.front, [](const TimedForm& timed) { return !is_drawable(timed); });
  std::erase_if(drawn.others, [](const TimedForm& timed) { return !is_drawable(timed); });
  return drawn;
}

/// The series that a point belongs to, by its column.
std::string series_of(const TimedForm& timed, bool is_on_front) {
  if (is_on_front) return "front";
  if (timed.is_reference) return "reference";
  return timed.is_double ? "double" : "float";
}

Table data_of(const Drawn& drawn) {
  Table table{{"ns", "front", "float", "double", "reference", "form", "precision", "width"}, {}};
  const auto add = [&](const TimedForm& timed, bool is_on_front) {
    std::vector<Cell> row(table.columns.size());
    row[0] = Number{timed.ns.median, 4};
    const auto column = std::find(table.columns.begin(), table.columns.end(), series_of(timed, is_on_front));
    row[static_cast<std::size_t>(column - table.columns.begin())] = Number{*timed.max_abs_error, 4};
    row[5] = full_id(timed);
    row[6] = std::string(timed.is_double ? "double" : "float");
    row[7] = std::string(forms::name(timed.width));
    table.rows.push_back(std::move(row));
  };
  for (const TimedForm& timed : drawn.front) add(timed, true);
  for (const TimedForm& timed : drawn.others) add(timed, false);
  return table;
}

/// What a point is called; off the front a reference by its width too, as there are several.
std::string point_name(const TimedForm& timed, bool is_on_front) {
  if (is_on_front) return timed.label + (timed.is_double ? ", double" : "");
  return timed.is_reference ? fmt::format("{} ({})", timed.form, forms::name(timed.width)) : full_id(timed);
}

/// Of the points off the front those that are named, in grey: the library's functions, and of each form in
/// float the fastest whose error is within a hundredth of the form's least.
std::vector<TimedForm> named_off_front(const Drawn& drawn) {
  constexpr double hundredth = 1.01;
  std::vector<TimedForm> named;
  for (const TimedForm& timed : drawn.others) {
    if (timed.is_double) continue;
    bool is_best = true;
    const auto compare = [&](const TimedForm& other, bool is_on_front) {
      if (other.form != timed.form || other.is_double || timed.is_reference) return;
      const bool is_as_exact = *other.max_abs_error <= hundredth * *timed.max_abs_error;
      const bool is_more_exact = hundredth * *other.max_abs_error < *timed.max_abs_error;
      // Of equal times the one of less error, and of equal ones the first.
      const bool is_faster =
          other.ns.median < timed.ns.median ||
          (other.ns.median == timed.ns.median && *other.max_abs_error < *timed.max_abs_error);
      if (is_on_front || is_more_exact || (is_as_exact && is_faster)) is_best = false;
    };
    for (const TimedForm& other : drawn.front) compare(other, true);
    for (const TimedForm& other : drawn.others) compare(other, false);
    if (is_best && !has(named, timed)) named.push_back(timed);
  }
  return named;
}

/// Points in a row along the line that joins others, for names to keep off.
void add_line(std::vector<Pixel>& points, const Pixel& from, const Pixel& to) {
  constexpr double step = 8;
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step);
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    points.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
}

/// gnuplot's commands for a name: the text, and a line to its point where it stands off.
std::string label_command(const Label& label, const std::string& name, const Pixel& point, bool is_on_front) {
  const Pixel& at = label.middle_left;
  std::string commands = fmt::format(
      "set label {} at graph {:.5f}, graph {:.5f} left noenhanced textcolor '{}' front\n",
      gnuplot_quoted(name), at.x / area.x, 1 - at.y / area.y, is_on_front ? "#101010" : "#707070");
  if (!label.has_leader) return commands;
  const double end = std::clamp(point.x, at.x, at.x + letter_width * static_cast<double>(name.size()));
  const double edge = at.y + (point.y > at.y ? line_height / 2 : -line_height / 2);
  return commands + fmt::format(
                        "set arrow from graph {:.5f}, graph {:.5f} to graph {:.5f}, graph {:.5f} nohead "
                        "lc rgb '#B0B0B0' lw 0.8 back\n",
                        end / area.x, 1 - edge / area.y, point.x / area.x, 1 - point.y / area.y);
}

std::string label_commands(const Drawn& drawn, const Axis& time, const Axis& error) {
  const auto pixel = [&](const TimedForm& timed) {
    return Pixel{area.x * time.share(timed.ns.median), area.y * (1 - error.share(*timed.max_abs_error))};
  };
  std::vector<TimedForm> named = drawn.front;
  for (const TimedForm& timed : named_off_front(drawn)) named.push_back(timed);
  std::vector<Pixel> points;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < named.size(); ++i) {
    points.push_back(pixel(named[i]));
    names.push_back(point_name(named[i], i < drawn.front.size()));
  }
  for (const TimedForm& timed : drawn.others) points.push_back(pixel(timed));
  for (std::size_t i = 1; i < drawn.front.size(); ++i)
    add_line(points, pixel(drawn.front[i - 1]), pixel(drawn.front[i]));
  const auto labels = place_labels(points, names, area);
  std::string commands;
  for (std::size_t i = 0; i < labels.size(); ++i)
    commands += label_command(labels[i], names[i], points[i], i < drawn.front.size());
  return commands;
}

/// A formula in gnuplot's markup: whatever is raised stands in braces, so that "c^(2^k) x" keeps its
/// exponents and its spaces.
std::string raised(std::string_view text) {
  std::string marked;
  while (!text.empty()) {
    marked += text.front();
    const bool is_raised = text.front() == '^';
    text.remove_prefix(1);
    if (!is_raised || text.empty()) continue;
    std::size_t end = 0;
    for (int depth = 0; end < text.size(); ++end) {
      const bool is_word = std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.';
      depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
      if (depth < 0 || (depth == 0 && !is_word && text[end] != ')')) break;
    }
    const bool has_parentheses = text.front() == '(' && end > 1;
    const std::string_view exponent = has_parentheses ? text.substr(1, end - 2) : text.substr(0, end);
    marked += "{" + raised(exponent) + "}";
    text.remove_prefix(end);
  }
  return marked;
}

}  // namespace

bool has_pareto_figure(const Trade& trade, const TimedTarget& target) {
  return !drawn_of(trade, target.id).all().empty();
}

Figure pareto_figure(const Trade& trade, const TimedTarget& target) {
  const Drawn drawn = drawn_of(trade, target.id);
  std::vector<double> times, errors;
  for (const TimedForm& timed : drawn.all()) {
    times.push_back(timed.ns.median);
    errors.push_back(*timed.max_abs_error);
  }
  const Axis time = axis_around(times, 0.06, 0.22), error = axis_around(errors, 0.08, 0.08);
  const std::string name = "pareto-" + target.id;
  Panel panel{
      .title = fmt::format("{}, on {}", raised(target.title), gnuplot_unmarked(trade.machine.cpu)),
      .x_label = "ns an element, data in L1, one core",
      .y_label = "largest absolute error",
      .settings = fmt::format("set logscale xy\nset xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n"
                              "set format y '10^{{%L}}'\nset format x '%g'\n",
                              time.low, time.high, error.low, error.high) +
                  label_commands(drawn, time, error),
      .abscissa = "ns",
      .curves = {
          {.column = "front", .label = "front", .look = Look::first, .has_points = true},
          {.column = "float", .label = "others, float", .look = Look::second, .is_joined = false},
          {.column = "double", .label = "others, double", .look = Look::third, .is_joined = false},
          {.column = "reference", .label = "by the library", .look = Look::fourth, .is_joined = false}}};
  // A legend names what there is.
  const Table data = data_of(drawn);
  std::erase_if(panel.curves, [&](const Curve& curve) {
    const auto column =
        std::find(data.columns.begin(), data.columns.end(), curve.column) - data.columns.begin();
    return std::all_of(data.rows.begin(), data.rows.end(), [&](const std::vector<Cell>& row) {
      return std::holds_alternative<std::monostate>(row[static_cast<std::size_t>(column)]);
    });
  });
  return {
      .name = name,
      .family = "",
      .caption = fmt::format("Error against time of {}: each form at its fastest width, data in L1. Forms on "
                             "the line are beaten by none.",
                             target.title),
      .data = data,
      .script = write_script({.name = name,
                              .about = "Run time against error: " + target.id,
                              .columns = 1,
                              .panel_height = static_cast<int>(area.y),
                              .panels = {panel}})};
}

}  // namespace shadefit::bench
