#include "fit/study_proof/prove_shape.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "fit/proof/constants.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study_proof/enclosed_error.hpp"
#include "fit/study_proof/lowest_value.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

std::vector<Interval> parameters_of(const StudySubject& subject, const ReadStudy& study) {
  const std::string fault = fault_of_constants(subject.parameters, study.parameters, "the form");
  if (!fault.empty()) throw UserError(fault);
  std::vector<Interval> parameters;
  for (const auto& [name, text] : subject.parameters) parameters.push_back(enclosed_constant(text).value());
  return parameters;
}

std::vector<std::string> shape_inputs(const ReadStudy& study) {
  std::vector<std::string> inputs;
  for (const StudyAxis& axis : study.axes) inputs.push_back(axis.variable);
  inputs.insert(inputs.end(), study.parameters.begin(), study.parameters.end());
  return inputs;
}

std::vector<Domain> ranges_of(const ReadStudy& study) {
  std::vector<Domain> ranges;
  for (const StudyAxis& axis : study.axes) ranges.push_back({axis.lower, axis.upper});
  return ranges;
}

/// A graph with a form, its ranges and its constants.
struct FormGraph {
  LowestValue lowest_of(int node) const { return {graph, node, ranges, parameters}; }

  Graph graph;
  std::vector<Domain> ranges;
  std::vector<Interval> parameters;
};

/// How far a form may violate a constraint on a box.
struct Violation {
  double amount;
  std::size_t axis = 0;                ///< the variable at which to cut the box
  std::optional<StudyBox> place = {};  ///< where it is proven to violate it by more than the slack
};

/// A constraint on a box.
using ShapeRule = std::function<Violation(const StudyBox&)>;

/// Cuts all boxes that violate the rule, again and again, until the violations are within the slack: their
/// sum if `adds`, otherwise each one.
ShapeProof prove(const ShapeRule& rule, bool adds, std::span<const Domain> ranges, double slack,
                 const Checkpoint& checkpoint) {
  ShapeProof result{Proof::open};
  std::vector<StudyBox> open = corners_of(ranges);
  while (result.boxes + open.size() <= most_shape_boxes) {
    std::vector<StudyBox> cut;
    Interval sum(0);
    for (const StudyBox& box : open) {
      checkpoint();
      ++result.boxes;
      const Violation found = rule(box);
      if (found.amount <= (adds ? 0 : slack)) continue;
      if (found.place) return {Proof::refuted, place_in(*found.place, ranges), result.boxes};
      sum = sum + Interval(found.amount);
      const auto halves = halves_of(box, found.axis);
      if (halves) {
        cut.insert(cut.end(), halves->begin(), halves->end());
      } else {
        cut.push_back(box);  // the sum may still be within the slack
      }
    }
    if (cut.empty() || (adds && upper_end(sum) <= slack)) {
      result.proof = Proof::proven;
      return result;
    }
    open = std::move(cut);
  }
  return result;
}

/// Proves that a node of the form's graph is at least a bound.
ShapeProof prove_bound(const FormGraph& form, int node, double bound, double slack,
                       const Checkpoint& checkpoint) {
  LowestValue lowest = form.lowest_of(node);
  const auto rule = [&](const StudyBox& box) {
    const LowestOnBox found = lowest.on(box, bound);
    Violation result{std::fmax(0, upper_end(Interval(bound) - Interval(found.lowest))), found.axis};
    if (result.amount > slack && lower_end(Interval(bound) - lowest.on(found.place).values) > slack)
      result.place = found.place;
    return result;
  };
  return prove(rule, false, form.ranges, slack, checkpoint);
}

/// How far a function may fall along a variable within a box.
Violation largest_fall(LowestValue& value, LowestValue& slope, const StudyBox& box, std::size_t variable) {
  const LowestOnBox values = value.on(box);
  // At a pole that two boxes share it may fall between them.
  if (values.may_have_pole) return {HUGE_VAL, values.axis};
  const double by_values = width_of(values.values);
  if (values.may_jump) return {by_values, values.axis};
  const LowestOnBox slopes = slope.on(box, 0);
  if (!is_bounded(slopes.values)) return {by_values, values.axis};
  const Interval width = Interval(box[variable].upper) - Interval(box[variable].lower);
  return {std::fmin(by_values, upper_end(Interval(width * Interval(std::fmax(0, -slopes.lowest))))),
          slopes.axis};
}

/// Proves that a node of the form's graph never falls along a variable.
ShapeProof prove_rise(FormGraph form, int node, std::size_t variable, double slack,
                      const Checkpoint& checkpoint) {
  LowestValue value = form.lowest_of(node);
  LowestValue slope = form.lowest_of(form.graph.derivative(node, variable));
  const auto rule = [&](const StudyBox& box) {
    Violation result = largest_fall(value, slope, box, variable);
    if (result.amount <= 0) return result;
    // Along one edge of the box.
    StudyBox from = box;
    for (auto& side : from) side.upper = side.lower;
    StudyBox to = from;
    to[variable].lower = to[variable].upper = box[variable].upper;
    if (lower_end(value.on(from).values - value.on(to).values) > slack) result.place = from;
    return result;
  };
  return prove(rule, true, form.ranges, slack, checkpoint);
}

}  // namespace

ShapeProof prove_exact(const StudySubject& subject, double end, double slack) {
  StudySubject plain = subject;
  plain.study.weight = "1";
  plain.study.error = Error::absolute;
  if (plain.study.rows || !fault_of(plain).empty()) return {Proof::open};
  const ReadStudy study = read_formulas(plain.study);
  if (study.axes.size() > 1) return {Proof::open};
  EnclosedError error(study, parameters_of(plain, study));
  const std::vector<double> place{end};
  const Interval difference = error.at(place);
  if (largest_magnitude_in(difference) <= slack) return {Proof::proven, {}, 1};
  if (smallest_magnitude_in(difference) > slack) return {Proof::refuted, place, 1};
  return {Proof::open, {}, 1};
}

ShapeProof prove_shape(const StudySubject& subject, const Constraints& constraint, double scale,
                       std::size_t variable, const Checkpoint& checkpoint) {
  if (!constraint.at_least && !constraint.at_most && !constraint.monotone) {
    if (constraint.exact_at.empty()) return {};
    return prove_exact(subject, constraint.exact_at.front(), exact_slack * scale);
  }
  const ReadStudy study = read_formulas(subject.study);
  if (integral_depth(study.form) > 0) return {Proof::open};
  FormGraph form{Graph(shape_inputs(study)), ranges_of(study), parameters_of(subject, study)};
  const int value = form.graph.add(study.form);
  // Added before the graph is copied.
  const int turned = form.graph.add(-study.form);
  const double slack = shape_slack * scale;
  if (constraint.at_least) return prove_bound(form, value, *constraint.at_least, slack, checkpoint);
  if (constraint.at_most) return prove_bound(form, turned, -*constraint.at_most, slack, checkpoint);
  return prove_rise(form, constraint.monotone == Course::rises ? value : turned, variable, slack, checkpoint);
}

}  // namespace shadefit
