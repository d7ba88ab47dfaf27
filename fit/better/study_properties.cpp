#include "fit/better/study_properties.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "approx/scalar.hpp"
#include "fit/bounds/prove_shape.hpp"
#include "fit/verdicts/verdict.hpp"

namespace shadefit {
namespace {

/// Two places that follow each other along a variable: all others are the same.
struct Neighbours {
  std::size_t first, second;
};

/// All neighbours along a variable. Empty if most places have none: scattered rows are no lines.
std::vector<Neighbours> neighbours_along(std::size_t variable, const std::vector<SampledPlace>& places) {
  const auto beside = [&](std::size_t i) {  // the place in the plane of the other variables
    SampledPlace place = places[i];
    place[variable] = 0;
    return place;
  };
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return std::pair(beside(a), places[a][variable]) < std::pair(beside(b), places[b][variable]);
  });
  std::vector<Neighbours> result;
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    if (beside(order[i]) == beside(order[i + 1])) result.push_back({order[i], order[i + 1]});
  return 2 * result.size() > places.size() ? result : std::vector<Neighbours>{};
}

/// Appends that the form rises or falls along a variable, if it does as its target does: but for `slack` no
/// value is below its neighbour, or none is above.
void append_course(const ReadStudy& study, const SampledCurve& curve, std::size_t variable, double slack,
                   std::vector<StudyProperty>& properties) {
  const std::vector<Neighbours> line = neighbours_along(variable, curve.places);
  if (line.empty()) return;
  const std::string along = study.axes.size() > 1 ? " in " + study.axes[variable].variable : "";
  for (const Course course : {Course::rises, Course::falls}) {
    const auto keeps = [&](const std::vector<double>& values) {
      return std::ranges::all_of(line, [&](const Neighbours& at) {
        const double before = values[at.first], after = values[at.second];
        return course == Course::rises ? after >= before - slack : after <= before + slack;
      });
    };
    if (keeps(curve.target) && keeps(curve.form))
      properties.push_back({std::string(name(course)) + along, {.monotone = course}, variable});
  }
}

bool are_all(const std::vector<double>& values, double lower, double upper) {
  return std::ranges::all_of(values, [&](double x) { return lower <= x && x <= upper; });
}

double error_at(const SampledCurve& curve, std::size_t i) {
  return std::abs(curve.form[i] - curve.target[i]);
}

/// The largest error at the places that a rule accepts.
template <class Rule>
double largest_error_where(const SampledCurve& curve, const Rule& is_wanted) {
  double largest = 0;
  for (std::size_t i = 0; i < curve.form.size(); ++i)
    if (is_wanted(i)) largest = std::fmax(largest, error_at(curve, i));
  return largest;
}

/// How far the form may move at each place if each printed constant moves by half a unit of its last digit.
std::vector<double> reach_of_digits(const ReadStudy& study, const std::vector<std::string>& printed,
                                    const std::vector<SampledPlace>& places) {
  std::vector<double> values;
  for (const std::string& text : printed) values.push_back(constant<double>(text));
  const std::vector<double> form = values_at(study, study.form, values, places);
  std::vector<double> reach(places.size(), 0.0);
  for (std::size_t k = 0; k < printed.size(); ++k) {
    std::vector<double> moved = values;
    moved[k] += last_unit(printed[k]) / 2;
    const std::vector<double> other = values_at(study, study.form, moved, places);
    for (std::size_t i = 0; i < places.size(); ++i) reach[i] += std::abs(other[i] - form[i]);
  }
  return reach;
}

/// Appends that the form is exact at all places of an end of a variable, if it is.
void append_end(const ReadStudy& study, const SampledCurve& curve, const std::vector<std::string>& printed,
                std::size_t axis, double end, std::vector<StudyProperty>& properties) {
  const auto is_at_end = [&](std::size_t i) { return curve.places[i][axis] == end; };
  const double error = largest_error_where(curve, is_at_end);
  StudyProperty exact{
      "exact at " + study.axes[axis].variable + " = " + to_text(end), {.exact_at = {end}}, axis};
  if (error <= exact_slack * size_of(curve)) {
    properties.push_back(exact);
    return;
  }
  const double largest = largest_error_where(curve, [](std::size_t) { return true; });
  if (printed.empty() || !(error <= share_by_chance * largest)) return;
  const std::vector<double> reach = reach_of_digits(study, printed, curve.places);
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    if (!is_at_end(i)) continue;
    if (!(error_at(curve, i) <= reach[i])) return;
    exact.digits = std::max(exact.digits, reach[i]);
  }
  properties.push_back(exact);
}

/// Properties after each other, each with what a function adds to it.
template <class Added>
std::string listed(const std::vector<StudyProperty>& properties, const Added& added) {
  std::string text;
  for (const StudyProperty& property : properties)
    text += (text.empty() ? "" : ", ") + property.words + (property.digits > 0 ? " to its digits" : "") +
            added(property);
  return text.empty() ? "none" : text;
}

}  // namespace

double size_of(const SampledCurve& curve) {
  double largest = 0;
  for (const double value : curve.target)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

std::vector<StudyProperty> properties_of(const ReadStudy& study, const SampledCurve& curve,
                                         const std::vector<std::string>& printed) {
  const double slack = shape_slack * size_of(curve);
  std::vector<StudyProperty> properties;
  for (std::size_t k = 0; k < study.axes.size() && !study.rows; ++k) {
    for (const double end : {study.axes[k].lower, study.axes[k].upper})
      append_end(study, curve, printed, k, end, properties);
  }
  for (std::size_t k = 0; k < study.axes.size(); ++k) append_course(study, curve, k, slack, properties);
  if (are_all(curve.target, 0, HUGE_VAL) && are_all(curve.form, -slack, HUGE_VAL))
    properties.push_back({"not negative", {.at_least = 0}});
  if (are_all(curve.target, -HUGE_VAL, 1) && are_all(curve.form, -HUGE_VAL, 1 + slack))
    properties.push_back({"at most 1", {.at_most = 1}});
  return properties;
}

std::vector<StudyProperty> lost_properties(const std::vector<StudyProperty>& wanted,
                                           const std::vector<StudyProperty>& found) {
  std::vector<StudyProperty> lost;
  std::ranges::copy_if(wanted, std::back_inserter(lost), [&](const StudyProperty& property) {
    return std::ranges::none_of(found,
                                [&](const StudyProperty& other) { return other.words == property.words; });
  });
  return lost;
}

std::string to_text(const std::vector<StudyProperty>& properties) {
  return listed(properties, [](const StudyProperty&) { return ""; });
}

std::string text_with_proofs(const std::vector<StudyProperty>& properties) {
  return listed(properties, [](const StudyProperty& property) {
    if (property.is_proven) return std::string(" (proven)");
    return property.unproven.empty() ? std::string(" (sampled)") : " (sampled: " + property.unproven + ")";
  });
}

Constraints constraints_of(const std::vector<StudyProperty>& properties) {
  Constraints all;
  for (const StudyProperty& property : properties) {
    const Constraints& one = property.constraints;
    all.exact_at.insert(all.exact_at.end(), one.exact_at.begin(), one.exact_at.end());
    if (one.monotone) all.monotone = one.monotone;
    if (one.at_least) all.at_least = one.at_least;
    if (one.at_most) all.at_most = one.at_most;
  }
  // Between exact ends a rising form has the bounds of its target.
  if (all.monotone && all.exact_at.size() == 2) all.at_least = all.at_most = std::nullopt;
  return all;
}

}  // namespace shadefit
