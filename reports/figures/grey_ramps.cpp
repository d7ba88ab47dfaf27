#include "reports/figures/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "approx/encoding.hpp"
#include "fit/better/sampled_curve.hpp"

namespace shadefit {
namespace {

constexpr double ramp_left = 112, ramp_width = 596, ramp_height = 36;

/// The code of a value in [0, 1] in 8 bits.
long grey_of(double value, bool is_encoded) {
  if (!std::isfinite(value)) return 0;
  return std::lround(is_encoded ? 255 * std::clamp(value, 0.0, 1.0) : srgb_code(value));
}

/// A rectangle for each part of the same grey.
std::string ramp(const std::vector<double>& values, bool is_encoded, double top, const std::string& name) {
  const double step = ramp_width / static_cast<double>(values.size());
  std::string svg = svg_text(ramp_left - 8, top + ramp_height / 2 + 4, "end", name);
  for (std::size_t first = 0, i = 0; i < values.size(); ++i) {
    const long grey = grey_of(values[i], is_encoded);
    if (i + 1 < values.size() && grey_of(values[i + 1], is_encoded) == grey) continue;
    svg += fmt::format(
        "<rect x=\"{0:.1f}\" y=\"{1:.0f}\" width=\"{2:.1f}\" height=\"{3:.0f}\" fill=\"rgb({4},{4},{4})\"/>\n",
        ramp_left + step * static_cast<double>(first), top, step * static_cast<double>(i + 1 - first),
        ramp_height, grey);
    first = i + 1;
  }
  return svg;
}

/// How far the codes of form and target differ at a sample.
double codes_apart(const SampledCurve& curve, std::size_t i, bool is_encoded) {
  return static_cast<double>(
      std::abs(grey_of(curve.form[i], is_encoded) - grey_of(curve.target[i], is_encoded)));
}

/// The samples of a line of rising x: of one variable all, of two those with this y.
SampledCurve line_of(const SampledCurve& curve, const std::optional<double>& y) {
  if (!y) return curve;
  std::map<double, std::size_t> by_x;
  for (std::size_t i = 0; i < curve.places.size(); ++i)
    if (curve.places[i][1] == *y) by_x[curve.places[i][0]] = i;
  SampledCurve line;
  for (const auto& [x, i] : by_x) {
    line.places.push_back(curve.places[i]);
    line.form.push_back(curve.form[i]);
    line.target.push_back(curve.target[i]);
  }
  return line;
}

/// The value of the second of two variables where the codes of form and target differ most.
std::optional<double> worst_line(const StudyComparison& comparison, const StudyContender& published) {
  if (comparison.variables.size() != 2) return std::nullopt;
  const SampledCurve curve = sample_curve(formulas_of(comparison, published), published.values);
  std::size_t worst = 0;
  for (std::size_t i = 1; i < curve.places.size(); ++i)
    if (codes_apart(curve, i, comparison.is_encoded) > codes_apart(curve, worst, comparison.is_encoded))
      worst = i;
  return curve.places[worst][1];
}

}  // namespace

GreyRamps grey_ramps(const StudyComparison& comparison,
                     const std::vector<const StudyContender*>& contenders) {
  // Rows of one variable may be anywhere; those of two are a grid if a line has enough of them.
  const std::size_t variables = comparison.variables.size();
  const bool has_lines = variables == 2 || (variables == 1 && !comparison.study.rows);
  const bool is_seen = has_lines && !contenders.empty() && contenders.front()->is_shown &&
                       codes_of(comparison, *contenders.front()) >= 1;
  if (!is_seen) return {};
  const std::optional<double> y = worst_line(comparison, *contenders.front());
  std::string ramps;
  double top = 0;
  for (const StudyContender* contender : contenders) {
    const SampledCurve curve =
        line_of(sample_curve(formulas_of(comparison, *contender), contender->values), y);
    constexpr std::size_t least_samples = 8;
    if (curve.form.size() < least_samples) return {};
    // The target is between the two, so that it touches both.
    ramps += ramp(curve.form, comparison.is_encoded, top, top == 0 ? "published" : "better");
    top += ramp_height;
    if (contender == contenders.front()) {
      ramps += ramp(curve.target, comparison.is_encoded, top, "target");
      top += ramp_height;
    }
  }
  return {
      fmt::format(
          "<svg viewBox=\"0 0 720 {:.0f}\" role=\"img\" shape-rendering=\"crispEdges\" aria-label=\"values as greys\">\n{}</svg>\n",
          top, ramps),
      y};
}

}  // namespace shadefit
