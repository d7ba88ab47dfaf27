#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "fit/support/decimal.hpp"
#include "reports/io/joined.hpp"
#include "reports/studies/study_rows.hpp"

/// Where a fit has its level, and where its constraints touch.
namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// 1 or -1 if the error is at the level on that side; 0 for the point of a constraint.
int sign_of_error(const AlternationPoint& point, const Constraints& constraints) {
  if (point.is_tangent) return 0;
  if (point.touch == Touch::highest) return constraints.one_sided == Side::below ? 0 : 1;
  if (point.touch == Touch::lowest) return constraints.one_sided == Side::above ? 0 : -1;
  return 0;
}

/// "level", or the active constraint: "form <= 1", "form = target".
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

/// "- at x = 0.5", "+ at (0.25, 1)".
std::string contact_text(const StudyContact& contact, const std::string& variable) {
  const std::string at = joined(contact.at, ", ", [](double x) { return fmt::format("{:.6g}", x); });
  const std::string place = contact.at.size() == 1 ? variable + " = " + at : "(" + at + ")";
  return fmt::format("{} at {}", contact.error < 0 ? "-" : "+", place);
}

/// "Level 0.5, the error is + at (0, 1), - at (1, 1)", and a line for each further level.
std::string contacts_text(const StudyFit& fit, const std::string& variable) {
  // Contacts of one level differ by rounding.
  constexpr double same = 1e-9;
  std::string text;
  double level = *fit.level;
  for (const StudyContact& contact : fit.touching) {
    const double magnitude = std::abs(contact.error);
    const bool is_lower = magnitude < level * (1 - same);
    if (is_lower)
      text += fmt::format("\nThe others have the level {:.10g}: ", level = magnitude);
    else if (!text.empty())
      text += ", ";
    text += contact_text(contact, variable);
  }
  return text;
}

}  // namespace

std::string level_text(const FittedStudy& study) {
  if (study.fit.status != Status::converged) return "";
  const StudyFit& fit = study.fit;
  const Constraints& constraints = study.objective.constraints;
  const std::string& variable = study.read.axes.front().variable;
  std::vector<std::string> places;
  std::string touching;
  for (const AlternationPoint& point : fit.alternation) {
    const int sign = sign_of_error(point, constraints);
    const std::string at = fmt::format("at {} = {:.6g}", variable, point.at.cos_theta);
    if (sign == 0)
      touching +=
          fmt::format("The optimum sits on the constraint {} {}\n", what_holds(point, constraints), at);
    else
      places.push_back((sign > 0 ? "+ " : "- ") + at);
  }
  const std::string at_bounds = joined(fit.at_bounds, "", [](const Held& at) {
    return fmt::format("{} is at its bound {}\n", at.parameter, to_text(at.value));
  });
  if (!fit.level) return touching + at_bounds;
  if (*fit.level == 0) return "Level 0: the form is its target.\n" + at_bounds;
  const char* others =
      fit.is_unique ? "" : "Other constants have this level too. These have the least mean square of them.\n";
  return fmt::format("Level {:.10g}, the error is {}{}\n{}{}{}", *fit.level, joined(places, ", "),
                     contacts_text(fit, variable), others, touching, at_bounds);
}

Json place_json(const FittedStudy& study, const std::vector<double>& at) {
  Json object = Json::object();
  for (std::size_t i = 0; i < at.size(); ++i) object[study.read.axes[i].variable] = at[i];
  return object;
}

Json alternation_json(const FittedStudy& study) {
  Json points = Json::array();
  const Constraints& constraints = study.objective.constraints;
  for (const AlternationPoint& point : study.fit.alternation) {
    points.push_back({{study.read.axes.front().variable, point.at.cos_theta},
                      {"error", point.error},
                      {"holds", what_holds(point, constraints)}});
  }
  for (const StudyContact& contact : study.fit.touching) {
    points.push_back(place_json(study, contact.at));
    points.back()["error"] = contact.error;
    points.back()["holds"] = "level";
  }
  return points;
}

}  // namespace shadefit
