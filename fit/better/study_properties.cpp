#include "fit/better/study_properties.hpp"

#include <algorithm>
#include <cmath>

#include "fit/study_proof/prove_shape.hpp"

namespace shadefit {
namespace {

/// Whether no value is below the one before it, by more than `slack`.
bool never_falls(const std::vector<double>& values, double slack) {
  return std::adjacent_find(values.begin(), values.end(),
                            [&](double a, double b) { return !(b >= a - slack); }) == values.end();
}

bool never_rises(const std::vector<double>& values, double slack) {
  return std::adjacent_find(values.begin(), values.end(),
                            [&](double a, double b) { return !(b <= a + slack); }) == values.end();
}

bool are_all(const std::vector<double>& values, double lower, double upper) {
  return std::all_of(values.begin(), values.end(), [&](double x) { return lower <= x && x <= upper; });
}

void append_ends(const StudyAxis& axis, const SampledCurve& curve, double largest,
                 std::vector<StudyProperty>& properties) {
  const double last_place = exact_slack * largest;
  const auto add = [&](std::size_t i, double end) {
    if (std::abs(curve.form[i] - curve.target[i]) <= last_place)
      properties.push_back({"exact at " + axis.variable + " = " + to_text(end), {.exact_at = {end}}});
  };
  add(0, axis.lower);
  add(curve.form.size() - 1, axis.upper);
}

/// In several variables: at all places of an end of one of them.
void append_edges(const std::vector<StudyAxis>& axes, const SampledCurve& curve, double largest,
                  std::vector<StudyProperty>& properties) {
  const double last_place = exact_slack * largest;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    for (const double end : {axes[k].lower, axes[k].upper}) {
      bool is_exact = true;
      for (std::size_t i = 0; i < curve.form.size(); ++i)
        is_exact = is_exact &&
                   (curve.places[i][k] != end || std::abs(curve.form[i] - curve.target[i]) <= last_place);
      if (is_exact) properties.push_back({"exact at " + axes[k].variable + " = " + to_text(end), {}});
    }
  }
}

/// Properties after each other, each with what a function adds to it.
template <class Added>
std::string listed(const std::vector<StudyProperty>& properties, const Added& added) {
  std::string text;
  for (const StudyProperty& property : properties)
    text += (text.empty() ? "" : ", ") + property.words + added(property);
  return text.empty() ? "none" : text;
}

}  // namespace

double size_of(const SampledCurve& curve) {
  double largest = 0;
  for (const double value : curve.target)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

std::vector<StudyProperty> properties_of(const ReadStudy& study, const SampledCurve& curve) {
  const double largest = size_of(curve), slack = shape_slack * largest;
  std::vector<StudyProperty> properties;
  if (study.axes.size() == 1 && !study.rows) {
    append_ends(study.axes.front(), curve, largest, properties);
    if (never_falls(curve.target, slack) && never_falls(curve.form, slack))
      properties.push_back({"rises", {.monotone = Course::rises}});
    if (never_rises(curve.target, slack) && never_rises(curve.form, slack))
      properties.push_back({"falls", {.monotone = Course::falls}});
  }
  if (study.axes.size() > 1 && !study.rows) append_edges(study.axes, curve, largest, properties);
  if (are_all(curve.target, 0, HUGE_VAL) && are_all(curve.form, -slack, HUGE_VAL))
    properties.push_back({"not negative", {.at_least = 0}});
  if (are_all(curve.target, -HUGE_VAL, 1) && are_all(curve.form, -HUGE_VAL, 1 + slack))
    properties.push_back({"at most 1", {.at_most = 1}});
  return properties;
}

std::vector<StudyProperty> lost_properties(const std::vector<StudyProperty>& wanted,
                                           const std::vector<StudyProperty>& found) {
  std::vector<StudyProperty> lost;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(lost), [&](const StudyProperty& property) {
    return std::none_of(found.begin(), found.end(),
                        [&](const StudyProperty& other) { return other.words == property.words; });
  });
  return lost;
}

std::string to_text(const std::vector<StudyProperty>& properties) {
  return listed(properties, [](const StudyProperty&) { return ""; });
}

std::string text_with_proofs(const std::vector<StudyProperty>& properties) {
  return listed(properties, [](const StudyProperty& property) {
    return property.is_proven ? " (proven)" : " (sampled)";
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
