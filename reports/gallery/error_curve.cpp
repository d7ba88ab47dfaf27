#include "reports/gallery/error_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "fit/study/largest_error.hpp"
#include "fit/tape/tape_program.hpp"
#include "reports/table/table.hpp"

namespace shadefit {
namespace {

constexpr double svg_width = 720, svg_height = 240, svg_left = 112, svg_right = 12, svg_top = 10,
                 svg_bottom = 30;
constexpr int steps = 240;
constexpr double svg_room = 1.05;  // above the largest error

/// The error at `steps` + 1 evenly spaced places. It is not finite if the form or the target has no value.
using ErrorValues = std::vector<double>;

ErrorValues values_along(const ReadStudy& study, const std::vector<double>& parameters) {
  const StudyAxis& axis = study.axes.front();
  TapeProgram<double> error(tape_of(weighted_error_of(study).form, formula_inputs(study)), parameters);
  ErrorValues values;
  for (int i = 0; i <= steps; ++i) {
    const double x = axis.lower + (axis.upper - axis.lower) * i / steps;
    error.run(std::span(&x, 1));
    values.push_back(error.output(0));
  }
  return values;
}

/// From the data to the picture: error 0 in the middle, +-`limit` at the edges.
class Frame {
 public:
  explicit Frame(double limit) : limit_(limit) {}
  double x(int step) const { return svg_left + (svg_width - svg_left - svg_right) * step / steps; }
  double y(double value) const {
    return svg_top + (svg_height - svg_top - svg_bottom) * (1 - value / limit_) / 2;
  }

 private:
  double limit_;
};

/// A line for each part without a gap.
std::string polylines(const ErrorValues& values, const Frame& frame, double limit, std::size_t number) {
  std::string lines, points;
  for (int i = 0; i <= steps + 1; ++i) {
    const double value = i <= steps ? values[static_cast<std::size_t>(i)] : HUGE_VAL;
    if (std::isfinite(value)) {
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", frame.x(i),
                            frame.y(std::clamp(value, -limit, limit)));
    } else if (!points.empty()) {
      lines += fmt::format("<polyline class=\"curve-{}\" points=\"{}\"/>\n", number, points);
      points.clear();
    }
  }
  return lines;
}

std::string label(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

}  // namespace

std::string error_curve_svg(const StudyComparison& comparison,
                            const std::vector<const StudyContender*>& contenders) {
  if (comparison.study.rows || comparison.study.over.size() != 1 || contenders.empty()) return "";
  const StudyAxis axis = formulas_of(comparison, *contenders.front()).axes.front();
  std::vector<ErrorValues> curves;
  double limit = 0;
  for (const StudyContender* contender : contenders) {
    curves.push_back(values_along(formulas_of(comparison, *contender), contender->values));
    limit = std::max(limit, contender->max_error.magnitude);
  }
  if (!(limit > 0) || !std::isfinite(limit)) return "";
  limit *= svg_room;
  const Frame frame(limit);
  const auto number = [](double value) { return text(Number{value, 3}, Precision::report); };
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"the error over {2}\">\n",
                  svg_width, svg_height, axis.variable);
  svg += fmt::format("<line class=\"axis\" x1=\"{0:.0f}\" x2=\"{1:.0f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n",
                     svg_left, svg_width - svg_right, frame.y(0));
  for (const double value : {limit / svg_room, 0.0, -limit / svg_room})
    svg += label(svg_left - 8, frame.y(value) + 4, "end", number(value));
  svg += label(svg_left, svg_height - 8, "start", number(axis.lower));
  svg += label((svg_left + svg_width - svg_right) / 2, svg_height - 8, "middle", axis.variable);
  svg += label(svg_width - svg_right, svg_height - 8, "end", number(axis.upper));
  for (std::size_t i = 0; i < curves.size(); ++i) svg += polylines(curves[i], frame, limit, i + 1);
  return svg + "</svg>\n";
}

}  // namespace shadefit
