#include "reports/gallery/grey_ramps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  std::string svg = fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text>\n",
                                ramp_left - 8, top + ramp_height / 2 + 4, name);
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

}  // namespace

std::string grey_ramps_svg(const StudyComparison& comparison,
                           const std::vector<const StudyContender*>& contenders) {
  const bool is_seen = comparison.variables.size() == 1 && !comparison.study.rows && !contenders.empty() &&
                       contenders.front()->is_shown && codes_of(comparison, *contenders.front()) >= 1;
  if (!is_seen) return "";
  std::string ramps;
  double top = 0;
  for (const StudyContender* contender : contenders) {
    const SampledCurve curve = sample_curve(formulas_of(comparison, *contender), contender->values);
    // The target is between the two, so that it touches both.
    ramps += ramp(curve.form, comparison.is_encoded, top, top == 0 ? "published" : "better");
    top += ramp_height;
    if (contender == contenders.front()) {
      ramps += ramp(curve.target, comparison.is_encoded, top, "target");
      top += ramp_height;
    }
  }
  return fmt::format(
      "<svg viewBox=\"0 0 720 {:.0f}\" role=\"img\" shape-rendering=\"crispEdges\" aria-label=\"values as greys\">\n{}</svg>\n",
      top, ramps);
}

}  // namespace shadefit
