#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/shading/tables.hpp"
#include "bench/tradeoff/labels.hpp"
#include "reports/figures/plot_script.hpp"

namespace shadefit::shade {
namespace {

/// Pixels of the area between the axes: as wide as a plot of one column is, see
/// reports/figures/plot_script.cpp.
constexpr bench::Pixel drawn_area{798, 420};

struct Point {
  const MeasuredWay* way;
  double error;
  std::string name;  ///< empty if it has the name of a neighbour
};

/// A tolerance of the sweep as a fraction of white.
std::string fraction(double tolerance) {
  return fmt::format("1/{}", std::lround(1 / tolerance));
}

/// Consecutive plans with one form and error have one name: "1/512 to 1/4096".
std::vector<Point> points_of(const Measurement& m) {
  std::vector<Point> points;
  const auto& sweep = m.sweep;
  for (std::size_t i = 0; i < sweep.size();) {
    std::size_t end = i + 1;
    while (end < sweep.size() && sweep[end].form == sweep[i].form &&
           sweep[end].errors.most_on(m.scale) == sweep[i].errors.most_on(m.scale))
      ++end;
    for (std::size_t k = i; k < end; ++k) {
      std::string name;
      if (k == i) {
        name = fraction(swept_tolerances[i]);
        if (end - i > 1) name += " to " + fraction(swept_tolerances[end - 1]);
        if (sweep[i].form == "no lobe") name += ": no lobe";
      }
      points.push_back({&sweep[k], sweep[k].errors.most_on(m.scale), name});
    }
    i = end;
  }
  points.push_back({&m.published, m.published.errors.most_on(m.scale), "published constants"});
  points.push_back(
      {&m.published_culled, m.published_culled.errors.most_on(m.scale), "published, in the plan's kernel"});
  // A logarithmic axis has no place for an error of 0.
  std::erase_if(points, [](const Point& point) { return !(point.error > 0 && point.way->ns > 0); });
  return points;
}

std::string name_commands(const std::vector<Point>& points, const bench::LogarithmicAxis& time,
                          const bench::LogarithmicAxis& error) {
  // Marks with a name first: `place_labels` names these and avoids the others.
  std::vector<Point> ordered = points;
  std::stable_partition(ordered.begin(), ordered.end(), [](const Point& p) { return !p.name.empty(); });
  std::vector<bench::Pixel> pixels;
  std::vector<std::string> names;
  for (const Point& point : ordered) {
    pixels.push_back(
        {drawn_area.x * time.share(point.way->ns), drawn_area.y * (1 - error.share(point.error))});
    if (!point.name.empty()) names.push_back(point.name);
  }
  const auto labels = bench::place_labels(pixels, names, drawn_area);
  std::string commands;
  for (std::size_t i = 0; i < labels.size(); ++i)
    commands += bench::label_commands(labels[i], names[i], pixels[i], drawn_area);
  return commands;
}

/// The reference has a time and no error: an upright line.
std::string reference_commands(double ns) {
  return fmt::format(
      "set arrow from first {0:.6g}, graph 0 to first {0:.6g}, graph 1 nohead ls 8 back\n"
      "set label 'reference' at first {0:.6g}, graph 0.03 left rotate by 90 offset character 0.9,0 textcolor "
      "'#707070'\n",
      ns);
}

/// 1, 2 and 5 of each decade, if decades are too few.
std::string time_tics(const bench::LogarithmicAxis& time) {
  constexpr double few_decades = 2.5;
  if (std::log10(time.high / time.low) > few_decades) return "";
  std::string tics;
  for (int decade = static_cast<int>(std::floor(std::log10(time.low))); std::pow(10, decade) < time.high;
       ++decade) {
    for (const int step : {1, 2, 5}) {
      const double at = step * std::pow(10, decade);
      if (at < time.low || at > time.high) continue;
      tics += fmt::format("{}{:.6g}", tics.empty() ? "set xtics (" : ", ", at);
    }
  }
  return tics + ")\n";
}

Table data_of_points(const std::vector<Point>& points, const Measurement& m) {
  Table table{.columns = {"ns", "planned", "published", "name", "form"}, .rows = {}};
  for (const Point& point : points) {
    const bool is_published = point.way == &m.published || point.way == &m.published_culled;
    const Cell error = Number{point.error, 4};
    table.rows.push_back({Number{point.way->ns, 4}, is_published ? Cell() : error,
                          is_published ? error : Cell(), point.name, point.way->form});
  }
  return table;
}

}  // namespace

Figure shade_figure(const Measurement& m) {
  const std::vector<Point> points = points_of(m);
  std::vector<double> times{m.reference.ns}, errors;
  for (const Point& point : points) {
    times.push_back(point.way->ns);
    errors.push_back(point.error);
  }
  if (errors.empty()) errors.push_back(1);  // without any error the axes still need a range
  const bench::LogarithmicAxis time = bench::axis_around(times, 0.06, 0.1),
                               error = bench::axis_around(errors, 0.1, 0.1);
  const std::string unit = m.scale == scene::ShownScale::linear ? "linear values" : "sRGB codes of 8 bits";
  const Panel panel{.title = "Plans for tolerances of 1/32 to 1/4096",
                    .x_label = fmt::format("ns a sample, {}, one core", forms::name(m.width)),
                    .y_label = "largest error of one light, " + unit,
                    .settings = bench::axis_settings(time, error) + time_tics(time) +
                                reference_commands(m.reference.ns) + name_commands(points, time, error),
                    .abscissa = "ns",
                    .curves = {{.column = "planned",
                                .label = "planned for this scene",
                                .look = Look::first,
                                .has_points = true,
                                .is_joined = false},
                               {.column = "published",
                                .label = "published constants",
                                .look = Look::second,
                                .has_points = true,
                                .is_joined = false}}};
  return {.name = "shade",
          .family = "",
          .caption = "Error against time of the plans for a scene and of the published constants.",
          .data = data_of_points(points, m),
          .script = write_script({.name = "shade",
                                  .about = "Run time against error of a scene's plans",
                                  .columns = 1,
                                  .panel_height = static_cast<int>(drawn_area.y),
                                  .panels = {panel}})};
}

}  // namespace shadefit::shade
