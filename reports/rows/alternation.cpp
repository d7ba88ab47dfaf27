#include "reports/rows/alternation.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

namespace shadefit {
namespace {

/// 1 or -1 if the error is at the level on that side; 0 for the point of a constraint.
int sign_of_error(const AlternationPoint& point, const Constraints& constraints) {
  if (point.is_tangent) return 0;
  if (point.touch == Touch::highest) return constraints.one_sided == Side::below ? 0 : 1;
  if (point.touch == Touch::lowest) return constraints.one_sided == Side::above ? 0 : -1;
  return 0;
}

}  // namespace

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

}  // namespace shadefit
