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
    case Touch::falls:
      return "form falls";
    case Touch::rises:
      return "form rises";
  }
  throw std::logic_error("an alternation point without a reason");
}

std::string level_places(const std::vector<AlternationPoint>& alternation, const Constraints& constraints,
                         const std::string& variable) {
  std::vector<std::string> places;
  for (const AlternationPoint& point : alternation) {
    const int sign = sign_of_error(point, constraints);
    if (sign != 0)
      places.push_back(fmt::format("{} at {} = {:.6g}", sign > 0 ? "+" : "-", variable, point.at.cos_theta));
  }
  return fmt::format("{}", fmt::join(places, ", "));
}

std::string touching_lines(const std::vector<AlternationPoint>& alternation, const Constraints& constraints,
                           const std::string& variable) {
  std::string lines;
  for (const AlternationPoint& point : alternation) {
    if (sign_of_error(point, constraints) == 0)
      lines += fmt::format("The optimum sits on the constraint {} at {} = {:.6g}\n",
                           what_holds(point, constraints), variable, point.at.cos_theta);
  }
  return lines;
}

std::string alternation_text(const Fit& fit) {
  if (!fit.level || fit.status != Status::converged) return "";
  if (fit.alternation.empty()) return "Level 0: the form is its target on all of the domain\n";
  const Constraints& constraints = fit.metric.constraints;
  const std::string exponent = fit.exponent ? fmt::format("k = {}: ", *fit.exponent) : "";
  return fmt::format("{}Level {:.10g}, the error is {}\n{}", exponent, *fit.level,
                     level_places(fit.alternation, constraints, "c"),
                     touching_lines(fit.alternation, constraints, "c"));
}

}  // namespace shadefit
