#include "reports/figures/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "fit/better/sampled_curve.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/study/largest_error.hpp"
#include "reports/io/table.hpp"

namespace shadefit {
namespace {

constexpr int picture_digits = 3;  // of a number beside a picture

constexpr double svg_width = 720, svg_height = 240, svg_left = 112, svg_right = 12, svg_top = 10,
                 svg_bottom = 30;
constexpr int steps = 240;
constexpr double svg_room = 1.05;  // above the largest error

/// A place along the picture, from 0 to 1, and the error there. It is not finite if the form or the target
/// has no value.
struct ErrorPoint {
  double share, error;
};

/// The error at `steps` + 1 evenly spaced places, and at `worst`, which may lie in a peak between two of
/// them.
std::vector<ErrorPoint> errors_along(const ReadStudy& study, const std::vector<double>& parameters,
                                     double worst) {
  const StudyAxis& axis = study.axes.front();
  const double width = axis.upper - axis.lower;
  std::vector<double> shares{(worst - axis.lower) / width};
  for (int i = 0; i <= steps; ++i) shares.push_back(static_cast<double>(i) / steps);
  std::ranges::sort(shares);
  TapeProgram<double> error(tape_of(weighted_error_of(study).form, formula_inputs(study)), parameters);
  std::vector<ErrorPoint> points;
  for (const double share : shares) {
    const double x = axis.lower + width * share;
    error.run(std::span(&x, 1));
    points.push_back({share, error.output(0)});
  }
  return points;
}

double x_of(double share) {
  return svg_left + (svg_width - svg_left - svg_right) * share;
}

/// Error 0 is in the middle, +-`limit` at the edges.
double y_of(double value, double limit) {
  return svg_top + (svg_height - svg_top - svg_bottom) * (1 - value / limit) / 2;
}

/// A line for each part without a gap.
std::string polylines(const std::vector<ErrorPoint>& curve, double limit, std::size_t number) {
  std::string lines, points;
  const auto end_line = [&] {
    if (!points.empty())
      lines += fmt::format("<polyline class=\"curve-{}\" points=\"{}\"/>\n", number, points);
    points.clear();
  };
  for (const auto& [share, error] : curve) {
    if (std::isfinite(error)) {
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", x_of(share),
                            y_of(std::clamp(error, -limit, limit), limit));
    } else {
      end_line();
    }
  }
  end_line();
  return lines;
}

constexpr double map_size = 300, map_gap = 90, map_left = 90, map_top = 32, map_bottom = 34;

/// The errors by x, then by y. With measured rows these are the values that occur.
using ErrorMap = std::map<double, std::map<double, double>>;

ErrorMap error_map(const StudyComparison& comparison, const StudyContender& contender) {
  const SampledCurve curve = sample_curve(formulas_of(comparison, contender), contender.values);
  const bool is_relative = comparison.error == "max_rel_error";
  ErrorMap errors;
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    const double difference = curve.form[i] - curve.target[i];
    errors[curve.places[i][0]][curve.places[i][1]] = is_relative ? difference / curve.target[i] : difference;
  }
  return errors;
}

double largest_error_in(const ErrorMap& errors) {
  double largest = 0;
  for (const auto& [x, column] : errors)
    for (const auto& [y, error] : column)
      if (std::isfinite(error)) largest = std::max(largest, std::abs(error));
  return largest;
}

/// Cells of equal size, starting at the lower left. A grid of 49 x 49 places is thinned to every second one.
std::string cells(const ErrorMap& errors, double limit, double left) {
  constexpr std::size_t most_in_a_row = 36;
  const std::size_t step = errors.size() > most_in_a_row ? 2 : 1;
  const std::size_t columns = (errors.size() + step - 1) / step;
  const double width = map_size / static_cast<double>(columns);
  std::string svg;
  std::size_t i = 0;
  for (const auto& [x, column] : errors) {
    const std::size_t rows = (column.size() + step - 1) / step;
    const double height = map_size / static_cast<double>(rows);
    std::size_t j = 0;
    for (const auto& [y, error] : column) {
      const double share = std::abs(error) / limit;
      if (i % step == 0 && j % step == 0 && share >= 0.005)  // fainter cells are not visible
        svg += fmt::format(
            "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill-opacity=\"{:.2f}\"/>\n",
            error > 0 ? "over" : "under", left + width * static_cast<double>(i / step),
            map_top + map_size - height * static_cast<double>(j / step + 1), width, height,
            std::min(share, 1.0));
      ++j;
    }
    ++i;
  }
  return svg +
         fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                     left, map_top, map_size, map_size);
}

std::string labels(const ErrorMap& errors, const std::vector<std::string>& variables, double left,
                   const std::string& title) {
  const auto& column = errors.begin()->second;
  const double below = map_top + map_size + 18;
  return svg_text(left, map_top - 8, "start", title) +
         svg_text(left, below, "start", in_digits(errors.begin()->first, picture_digits)) +
         svg_text(left + map_size / 2, below, "middle", variables[0]) +
         svg_text(left + map_size, below, "end", in_digits(errors.rbegin()->first, picture_digits)) +
         svg_text(left - 6, map_top + map_size, "end", in_digits(column.begin()->first, picture_digits)) +
         svg_text(left - 6, map_top + map_size / 2, "end", variables[1]) +
         svg_text(left - 6, map_top + 10, "end", in_digits(column.rbegin()->first, picture_digits));
}

}  // namespace

std::string svg_text(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string error_curve_svg(const StudyComparison& comparison,
                            const std::vector<const StudyContender*>& contenders) {
  if (comparison.study.rows || comparison.study.over.size() != 1 || contenders.empty()) return "";
  const StudyAxis axis = formulas_of(comparison, *contenders.front()).axes.front();
  std::vector<std::vector<ErrorPoint>> curves;
  double limit = 0;
  for (const StudyContender* contender : contenders) {
    curves.push_back(errors_along(formulas_of(comparison, *contender), contender->values,
                                  contender->max_error.at.front()));
    limit = std::max(limit, contender->max_error.magnitude);
  }
  if (!(limit > 0) || !std::isfinite(limit)) return "";
  limit *= svg_room;
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"the error over {2}\">\n",
                  svg_width, svg_height, axis.variable);
  svg += fmt::format("<line class=\"axis\" x1=\"{0:.0f}\" x2=\"{1:.0f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n",
                     svg_left, svg_width - svg_right, y_of(0, limit));
  for (const double value : {limit / svg_room, 0.0, -limit / svg_room})
    svg += svg_text(svg_left - 8, y_of(value, limit) + 4, "end", in_digits(value, picture_digits));
  svg += svg_text(svg_left, svg_height - 8, "start", in_digits(axis.lower, picture_digits));
  svg += svg_text((svg_left + svg_width - svg_right) / 2, svg_height - 8, "middle", axis.variable);
  svg += svg_text(svg_width - svg_right, svg_height - 8, "end", in_digits(axis.upper, picture_digits));
  for (std::size_t i = 0; i < curves.size(); ++i) svg += polylines(curves[i], limit, i + 1);
  return svg + "</svg>\n";
}

std::string heat_map_svg(const StudyComparison& comparison,
                         const std::vector<const StudyContender*>& contenders) {
  if (comparison.variables.size() != 2 || contenders.empty()) return "";
  std::vector<ErrorMap> maps;
  double limit = 0;
  for (const StudyContender* contender : contenders) {
    maps.push_back(error_map(comparison, *contender));
    limit = std::max(limit, largest_error_in(maps.back()));
  }
  if (!(limit > 0)) return "";
  // Room for two maps, so that one alone is not larger.
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" shape-rendering=\"crispEdges\" aria-label=\"the error over {} and {}\">\n",
      map_left + 2 * map_size + map_gap + 10, map_top + map_size + map_bottom, comparison.variables[0],
      comparison.variables[1]);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const double left = map_left + static_cast<double>(i) * (map_size + map_gap);
    svg += cells(maps[i], limit, left) + labels(maps[i], comparison.variables, left,
                                                (i == 0 ? "as published, at most " : "better, at most ") +
                                                    in_digits(largest_error_in(maps[i]), picture_digits));
  }
  return svg + "</svg>\n";
}

}  // namespace shadefit
