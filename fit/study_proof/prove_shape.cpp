#include "fit/study_proof/prove_shape.hpp"

#include <cmath>
#include <functional>
#include <optional>

#include "fit/proof/constants.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study_proof/enclosed_error.hpp"
#include "fit/study_proof/lowest_value.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A form as a graph, and its constants.
struct FormGraph {
  explicit FormGraph(const StudySubject& subject, const ReadStudy& study) : graph(inputs_of(study)) {
    for (const StudyAxis& axis : study.axes) ranges.push_back({axis.lower, axis.upper});
    for (const auto& [name, text] : subject.parameters) parameters.push_back(enclosed_constant(text).value());
  }

  static std::vector<std::string> inputs_of(const ReadStudy& study) {
    std::vector<std::string> inputs;
    for (const StudyAxis& axis : study.axes) inputs.push_back(axis.variable);
    inputs.insert(inputs.end(), study.parameters.begin(), study.parameters.end());
    return inputs;
  }
  LowestValue lowest_of(int node) const { return {graph, node, ranges, parameters}; }

  Graph graph;
  std::vector<Domain> ranges;
  std::vector<Interval> parameters;
};

/// How far a form may violate a constraint on a box, and the variable at which to cut it.
struct Violation {
  double amount;
  std::size_t axis;
};

/// A constraint on boxes.
struct ShapeRule {
  std::function<Violation(const StudyBox&)> violation;
  std::function<bool(const StudyBox&)> fails;  ///< whether a place in a box certainly violates it too much
  bool adds;  ///< whether the violations of all boxes add up; else each one counts alone
};

/// Cuts all boxes that violate the rule, again and again.
ShapeProof prove(const ShapeRule& rule, std::span<const Domain> ranges, double slack,
                 const Checkpoint& checkpoint) {
  ShapeProof result{Proof::open};
  std::vector<StudyBox> open = corners_of(ranges);
  while (result.boxes + open.size() <= most_shape_boxes) {
    std::vector<StudyBox> cut;
    Interval sum(0);
    for (const StudyBox& box : open) {
      checkpoint();
      ++result.boxes;
      const Violation found = rule.violation(box);
      if (found.amount <= (rule.adds ? 0 : slack)) continue;
      if (rule.fails(box)) return {Proof::refuted, place_in(box, ranges), result.boxes};
      sum = sum + Interval(found.amount);
      const auto halves = halves_of(box, found.axis);
      if (halves) {
        cut.insert(cut.end(), halves->begin(), halves->end());
      } else {
        cut.push_back(box);  // its violation may be small enough beside the others
      }
    }
    if (cut.empty() || (rule.adds && upper_end(sum) <= slack)) {
      result.proof = Proof::proven;
      return result;
    }
    open = std::move(cut);
  }
  return result;
}

StudyBox middle_of_box(StudyBox box) {
  for (Stretch& side : box) side = middle_of(side);
  return box;
}

/// That a node of the form's graph is at least a bound.
ShapeProof prove_bound(const FormGraph& form, int node, double bound, double slack,
                       const Checkpoint& checkpoint) {
  LowestValue lowest = form.lowest_of(node);
  const auto under = [&](double value) { return upper_end(Interval(bound) - Interval(value)); };
  const ShapeRule rule{.violation =
                           [&](const StudyBox& box) {
                             const LowestOnBox found = lowest.on(box, bound);
                             return Violation{std::fmax(0, under(found.lowest)), found.axis};
                           },
                       .fails =
                           [&](const StudyBox& box) {
                             const Interval below = Interval(bound) - lowest.on(middle_of_box(box)).values;
                             return lower_end(below) > slack;
                           },
                       .adds = false};
  return prove(rule, form.ranges, slack, checkpoint);
}

/// That a node of the form's graph never falls.
ShapeProof prove_rise(FormGraph form, int node, double slack, const Checkpoint& checkpoint) {
  LowestValue value = form.lowest_of(node);
  LowestValue slope = form.lowest_of(form.graph.derivative(node, 0));
  const auto fall_on = [&](const StudyBox& box) {
    const LowestOnBox values = value.on(box);
    const double by_values = is_bounded(values.values) ? width_of(values.values) : HUGE_VAL;
    if (values.may_jump || std::isinf(by_values)) return by_values;
    const LowestOnBox slopes = slope.on(box, 0);
    if (!is_bounded(slopes.values)) return by_values;
    if (slopes.lowest >= 0) return 0.0;
    const Interval width = Interval(box[0].upper) - Interval(box[0].lower);
    return std::fmin(by_values, upper_end(Interval(width * Interval(-slopes.lowest))));
  };
  const ShapeRule rule{.violation =
                           [&](const StudyBox& box) {
                             return Violation{fall_on(box), 0};
                           },
                       .fails =
                           [&](const StudyBox& box) {
                             StudyBox from = box, to = box;
                             from[0].upper = from[0].lower;
                             to[0].lower = to[0].upper;
                             const Interval fall = value.on(from).values - value.on(to).values;
                             return lower_end(fall) > slack;
                           },
                       .adds = true};
  return prove(rule, form.ranges, slack, checkpoint);
}

/// That the form is its target at an end.
ShapeProof prove_exact(const StudySubject& subject, double end, double slack) {
  StudySubject plain = subject;
  plain.study.weight = "1";
  plain.study.error = Error::absolute;
  if (plain.study.rows || !fault_of(plain).empty()) return {Proof::open};
  const ReadStudy study = read_formulas(plain.study);
  if (study.axes.size() > 1) return {Proof::open};
  EnclosedError error(study, FormGraph(plain, study).parameters);
  const std::vector<double> place{end};
  const Interval difference = error.at(place);
  if (largest_magnitude_in(difference) <= slack) return {Proof::proven, {}, 1};
  if (smallest_magnitude_in(difference) > slack) return {Proof::refuted, place, 1};
  return {Proof::open, {}, 1};
}

}  // namespace

ShapeProof prove_shape(const StudySubject& subject, const Constraints& constraint, double scale,
                       const Checkpoint& checkpoint) {
  if (!constraint.at_least && !constraint.at_most && !constraint.monotone) {
    if (constraint.exact_at.empty()) return {};
    return prove_exact(subject, constraint.exact_at.front(), exact_slack * scale);
  }
  const ReadStudy study = read_formulas(subject.study);
  if (integral_depth(study.form) > 0) return {Proof::open};
  FormGraph form(subject, study);
  const int value = form.graph.add(study.form);
  const auto turned = [&] { return form.graph.add(-study.form); };
  const double slack = shape_slack * scale;
  if (constraint.at_least) return prove_bound(form, value, *constraint.at_least, slack, checkpoint);
  if (constraint.at_most) return prove_bound(form, turned(), -*constraint.at_most, slack, checkpoint);
  if (study.axes.size() > 1) return {Proof::open};
  return prove_rise(form, constraint.monotone == Course::rises ? value : turned(), slack, checkpoint);
}

}  // namespace shadefit
