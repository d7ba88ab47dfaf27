#include "reports/figures/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "fit/formula/tape_program.hpp"
#include "fit/study/largest_error.hpp"
#include "reports/io/table.hpp"

namespace shadefit {
namespace {

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
  const auto number = [](double value) { return text(Number{value, 3}, Precision::report); };
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"the error over {2}\">\n",
                  svg_width, svg_height, axis.variable);
  svg += fmt::format("<line class=\"axis\" x1=\"{0:.0f}\" x2=\"{1:.0f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n",
                     svg_left, svg_width - svg_right, y_of(0, limit));
  for (const double value : {limit / svg_room, 0.0, -limit / svg_room})
    svg += svg_text(svg_left - 8, y_of(value, limit) + 4, "end", number(value));
  svg += svg_text(svg_left, svg_height - 8, "start", number(axis.lower));
  svg += svg_text((svg_left + svg_width - svg_right) / 2, svg_height - 8, "middle", axis.variable);
  svg += svg_text(svg_width - svg_right, svg_height - 8, "end", number(axis.upper));
  for (std::size_t i = 0; i < curves.size(); ++i) svg += polylines(curves[i], limit, i + 1);
  return svg + "</svg>\n";
}

}  // namespace shadefit
