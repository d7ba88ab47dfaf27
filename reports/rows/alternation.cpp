#include "reports/rows/alternation.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

namespace shadefit {

int sign_of_error(const AlternationPoint& point, const Constraints& constraints) {
  if (point.is_tangent) return 0;
  if (point.touch == Touch::highest) return constraints.one_sided == Side::below ? 0 : 1;
  if (point.touch == Touch::lowest) return constraints.one_sided == Side::above ? 0 : -1;
  return 0;
}

std::string what_holds(const AlternationPoint& point, const Constraints& constraints) {
  if (sign_of_error(point, constraints) != 0) return "level";
  const std::string by_slope = point.is_tangent ? " by its slope" : "";
  switch (point.touch) {
    case Touch::highest:
      return "form <= target" + by_slope;
    case Touch::lowest:
      return "form >= target" + by_slope;
    case Touch::exact:
      return "form = target";
    case Touch::at_most:
      return "form <= " + to_text(*constraints.at_most) + by_slope;
    case Touch::at_least:
      return "form >= " + to_text(*constraints.at_least) + by_slope;
  }
  throw std::logic_error("an alternation point without a reason");
}

std::string alternation_text(const Fit& fit) {
  if (!fit.level || fit.status != Status::converged) return "";
  const Constraints& constraints = fit.metric.constraints;
  std::vector<std::string> places, lines;
  for (const AlternationPoint& point : fit.alternation) {
    const int sign = sign_of_error(point, constraints);
    const std::string where = fmt::format("at c = {:.6g}", point.at.cos_theta);
    if (sign != 0) {
      places.push_back((sign > 0 ? "+ " : "- ") + where);
    } else {
      lines.push_back(
          fmt::format("The optimum sits on the constraint {} {}\n", what_holds(point, constraints), where));
    }
  }
  if (fit.alternation.empty()) return "Level 0: the form is its target on all of the domain\n";
  const std::string exponent = fit.exponent ? fmt::format("k = {}: ", *fit.exponent) : "";
  return fmt::format("{}Level {:.10g}, the error is {}\n{}", exponent, *fit.level, fmt::join(places, ", "),
                     fmt::join(lines, ""));
}

}  // namespace shadefit
