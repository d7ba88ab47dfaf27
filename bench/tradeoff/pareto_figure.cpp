#include "bench/tradeoff/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "bench/tradeoff/labels.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/escape.hpp"

namespace shadefit::bench {
namespace {

/// Pixels of the area between the axes: as wide as a plot of one column is, see
/// reports/figures/plot_script.cpp.
constexpr Pixel area{798, 470};

/// What is drawn: few marks, each with its name.
struct Drawn {
  std::vector<TimedForm> front;   ///< the fastest first, so that a line joins them
  std::vector<TimedForm> others;  ///< one for each form that is not on the front, and the references
};

/// A logarithmic axis has no place for an error of 0.
bool is_drawable(const TimedForm& timed) {
  return precision_of(timed) == "float" && timed.max_abs_error && *timed.max_abs_error > 0 &&
         std::isfinite(*timed.max_abs_error) && timed.ns.median > 0;
}

/// Of the constants and the degrees of exp2 of one form: the fastest, of those with an error within a
/// hundredth of the least.
bool is_better_mark(const TimedForm& a, const TimedForm& b) {
  constexpr double hundredth = 1.01;
  if (hundredth * *a.max_abs_error < *b.max_abs_error) return true;
  return *a.max_abs_error <= hundredth * *b.max_abs_error && a.ns.median < b.ns.median;
}

/// The forms of a target in float, as shaders compute, each at its fastest width, and the target's own
/// formula in scalar code.
std::vector<TimedForm> drawable_forms(const Trade& trade, const std::string& target) {
  std::vector<TimedForm> forms = fastest_of(trade, target);
  for (const TimedForm& timed : trade.forms) {
    const bool is_scalar_reference = timed.target == target && timed.is_reference &&
                                     timed.width == forms::Width::scalar &&
                                     timed.place == DataPlace::first_cache;
    const bool is_there = std::any_of(forms.begin(), forms.end(),
                                      [&](const TimedForm& form) { return is_same_way(form, timed); });
    if (is_scalar_reference && !is_there) forms.push_back(timed);
  }
  std::erase_if(forms, [](const TimedForm& timed) { return !is_drawable(timed); });
  return forms;
}

Drawn drawn_of(const Trade& trade, const std::string& target) {
  const std::vector<TimedForm> forms = drawable_forms(trade, target);
  Drawn drawn{.front = front_among(forms), .others = {}};
  for (const TimedForm& form : forms) {
    const auto is_same_mark = [&](const TimedForm& mark) {
      return mark.form == form.form && (!form.is_reference || mark.width == form.width);
    };
    if (std::any_of(drawn.front.begin(), drawn.front.end(), is_same_mark)) continue;
    const auto same = std::find_if(drawn.others.begin(), drawn.others.end(), is_same_mark);
    if (same == drawn.others.end()) {
      drawn.others.push_back(form);
    } else if (is_better_mark(form, *same)) {
      *same = form;
    }
  }
  return drawn;
}

Table data_of(const Drawn& drawn) {
  Table table{{"ns", "front", "form", "reference", "name", "width"}, {}};
  const auto add = [&](const TimedForm& timed, bool is_on_front) {
    std::vector<Cell> row(table.columns.size());
    row[0] = Number{timed.ns.median, 4};
    const char* series = is_on_front ? "front" : timed.is_reference ? "reference" : "form";
    const auto column = std::ranges::find(table.columns, series);
    row[static_cast<std::size_t>(column - table.columns.begin())] = Number{*timed.max_abs_error, 4};
    row[4] = full_id(timed);
    row[5] = timed.on_device ? "" : std::string(forms::name(timed.width));
    table.rows.push_back(std::move(row));
  };
  for (const TimedForm& timed : drawn.front) add(timed, true);
  for (const TimedForm& timed : drawn.others) add(timed, false);
  return table;
}

/// The name beside a mark. A reference stands there once for each width.
std::string mark_name(const TimedForm& timed) {
  return timed.is_reference && !timed.on_device ? fmt::format("{} ({})", timed.form, forms::name(timed.width))
                                                : full_id(timed);
}

/// Points along the line that joins the front: names avoid them.
void add_line(std::vector<Pixel>& points, const Pixel& from, const Pixel& to) {
  constexpr double step = 8;
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step);
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    points.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
}

std::string name_commands(const Drawn& drawn, const LogarithmicAxis& time, const LogarithmicAxis& error) {
  const auto pixel = [&](const TimedForm& timed) {
    return Pixel{area.x * time.share(timed.ns.median), area.y * (1 - error.share(*timed.max_abs_error))};
  };
  std::vector<TimedForm> marks = drawn.front;
  marks.insert(marks.end(), drawn.others.begin(), drawn.others.end());
  std::vector<Pixel> points;
  std::vector<std::string> names;
  for (const TimedForm& mark : marks) {
    points.push_back(pixel(mark));
    names.push_back(mark_name(mark));
  }
  for (std::size_t i = 1; i < drawn.front.size(); ++i)
    add_line(points, pixel(drawn.front[i - 1]), pixel(drawn.front[i]));
  const auto labels = place_labels(points, names, area);
  std::string commands;
  for (std::size_t i = 0; i < labels.size(); ++i)
    commands += label_commands(labels[i], names[i], points[i], area,
                               i < drawn.front.size() ? " textcolor '#101010'" : " textcolor '#707070'");
  return commands;
}

/// A formula in gnuplot's markup. Exponents get braces, so that "c^(2^k) x" keeps its exponents and its
/// spaces.
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
  return !drawn_of(trade, target.id).front.empty();
}

Figure pareto_figure(const Trade& trade, const TimedTarget& target) {
  const Drawn drawn = drawn_of(trade, target.id);
  std::vector<double> times, errors;
  for (const std::vector<TimedForm>& marks : {drawn.front, drawn.others}) {
    for (const TimedForm& mark : marks) {
      times.push_back(mark.ns.median);
      errors.push_back(*mark.max_abs_error);
    }
  }
  const bool is_graphics = trade.machine.is_graphics();
  const LogarithmicAxis time = axis_around(times, 0.06, 0.22), error = axis_around(errors, 0.08, 0.08);
  const std::string name = "pareto-" + target.id;
  Panel panel{.title = fmt::format("{}, on {}", raised(target.title),
                                   for_gnuplot(is_graphics ? trade.machine.device : trade.machine.cpu)),
              .x_label = is_graphics ? "time of an evaluation in ns, float, on the whole device"
                                     : "time of an element in ns, float, data in L1, one core",
              .y_label = "largest absolute error",
              .settings = axis_settings(time, error) + name_commands(drawn, time, error),
              .abscissa = "ns",
              .curves = {{.column = "front", .label = "unbeaten", .look = Look::first, .has_points = true},
                         {.column = "form", .label = "other forms", .look = Look::second, .is_joined = false},
                         {.column = "reference",
                          .label = is_graphics ? "the target itself" : "by the C library",
                          .look = Look::fourth,
                          .is_joined = false}}};
  // The legend names only series with data.
  const Table data = data_of(drawn);
  std::erase_if(panel.curves, [&](const Curve& curve) {
    const auto column =
        std::find(data.columns.begin(), data.columns.end(), curve.column) - data.columns.begin();
    return std::all_of(data.rows.begin(), data.rows.end(), [&](const std::vector<Cell>& row) {
      return std::holds_alternative<std::monostate>(row[static_cast<std::size_t>(column)]);
    });
  });
  return {.name = name,
          .family = "",
          .caption = fmt::format("Error against time of {}: each form in float{}. "
                                 "No form is both faster and more accurate than one on the line.",
                                 target.title, is_graphics ? "" : " at its fastest width, data in L1"),
          .data = data,
          .script = write_script({.name = name,
                                  .about = "Run time against error: " + target.id,
                                  .columns = 1,
                                  .panel_height = static_cast<int>(area.y),
                                  .panels = {panel}})};
}

}  // namespace shadefit::bench
