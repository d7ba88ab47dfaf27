#include "fit/bounds/prove_shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/bounds/cut_boxes.hpp"
#include "fit/bounds/enclosed_error.hpp"
#include "fit/bounds/lowest_value.hpp"
#include "fit/formula/graph.hpp"
#include "fit/proof/constants.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The inputs of a form in interval arithmetic.
struct FormInputs {
  std::vector<std::string> names;  ///< the variables, one for each range, then the parameters
  std::vector<Domain> ranges;
  std::vector<Interval> parameters;

  /// A formula of these inputs, bounded from below.
  LowestValue lowest_of(const Symbolic& formula) const {
    Graph graph(names);
    const int node = graph.add(formula);
    return {std::move(graph), node, ranges, parameters};
  }
  /// Its slope along a variable.
  LowestValue slope_of(const Symbolic& formula, std::size_t variable) const {
    Graph graph(names);
    const int node = graph.derivative(graph.add(formula), variable);
    return {std::move(graph), node, ranges, parameters};
  }
};

std::vector<Interval> parameters_of(const StudySubject& subject, const ReadStudy& study) {
  const std::string fault = fault_of_constants(subject.parameters, study.parameters, "the form");
  if (!fault.empty()) throw UserError(fault);
  return enclosed_constants(subject.parameters);
}

FormInputs inputs_of_form(const StudySubject& subject, const ReadStudy& study) {
  FormInputs inputs{formula_inputs(study), {}, parameters_of(subject, study)};
  for (const StudyAxis& axis : study.axes) inputs.ranges.push_back({axis.lower, axis.upper});
  return inputs;
}

ShapeProof without_boxes(const std::string& reason) {
  return {Proof::open, {}, 0, reason};
}

/// Proves that a form is at least a bound.
ShapeProof prove_bound(const Symbolic& form, const FormInputs& inputs, double bound, double slack,
                       const Checkpoint& checkpoint) {
  LowestValue lowest = inputs.lowest_of(form);
  const auto rule = [&](const StudyBox& box) {
    const LowestOnBox found = lowest.on(box, bound);
    Violation result{std::fmax(0, upper_end(Interval(bound) - Interval(found.lowest))), found.axis};
    if (result.amount > slack && lower_end(Interval(bound) - lowest.on(found.place).values) > slack)
      result.place = place_in(found.place, inputs.ranges);
    return result;
  };
  return prove_on_boxes(inputs.ranges, rule, each_above(slack), checkpoint);
}

/// Adds the choices of a formula to a list, equal ones once.
void append_choices(const Symbolic& formula, std::vector<Symbolic>& choices) {
  const auto is_same = [&](const Symbolic& other) { return to_text(other) == to_text(formula); };
  if (formula.kind() == Symbolic::Kind::choice && std::ranges::none_of(choices, is_same))
    choices.push_back(formula);
  for (const Symbolic& part : formula.parts()) append_choices(part, choices);
}

/// A formula with one of its parts, 2 or 3, in place of its only choice.
Symbolic side_of_choice(const Symbolic& formula, std::size_t side) {
  if (formula.kind() == Symbolic::Kind::choice) return formula.part(side);
  if (formula.parts().empty()) return formula;
  std::vector<Symbolic> parts;
  for (const Symbolic& part : formula.parts()) parts.push_back(side_of_choice(part, side));
  return formula.with_parts(std::move(parts));
}

/// How far a function may fall along a variable within a box.
struct Fall {
  double amount;
  std::size_t axis;  ///< the variable at which to cut the box
  bool may_jump = false;
};

/// A function and its slope along a variable.
class FormCourse {
 public:
  FormCourse(const Symbolic& form, const FormInputs& inputs, std::size_t variable)
      : variable_(variable), value_(inputs.lowest_of(form)), slope_(inputs.slope_of(form, variable)) {}

  Fall largest_fall(const StudyBox& box) {
    const LowestOnBox values = value_.on(box);
    // At a pole that two boxes share it may fall between them.
    if (values.may_have_pole) return {HUGE_VAL, values.axis};
    const double by_values = width_of(values.values);
    if (values.may_jump) return {by_values, values.axis, true};
    const LowestOnBox slopes = slope_.on(box, 0);
    if (!is_bounded(slopes.values)) return {by_values, values.axis};
    const Interval width = Interval(box[variable_].upper) - Interval(box[variable_].lower);
    const Interval by_slope = width * Interval(std::fmax(0, -slopes.lowest));
    return {std::fmin(by_values, upper_end(by_slope)), slopes.axis};
  }

  Interval values_on(const StudyBox& box) { return value_.on(box).values; }

 private:
  std::size_t variable_;
  LowestValue value_, slope_;
};

/// A form whose only choice may switch along the variable, from one side to the other.
class SwitchedCourse {
 public:
  SwitchedCourse(const Symbolic& before, const Symbolic& after, bool is_crossed, const FormInputs& inputs,
                 std::size_t variable)
      : is_crossed_(is_crossed),
        before_(before, inputs, variable),
        after_(after, inputs, variable),
        step_(inputs.lowest_of(after - before)) {}

  Fall largest_fall(const StudyBox& box) {
    const Fall before = before_.largest_fall(box), after = after_.largest_fall(box);
    const Fall larger = before.amount < after.amount ? after : before;
    if (!is_crossed_) return larger;
    const LowestOnBox step = step_.on(box, 0);
    const double down = std::fmax(0, -step.lowest);
    const Interval sum = Interval(before.amount) + Interval(after.amount) + Interval(down);
    return {upper_end(sum), larger.amount < down ? step.axis : larger.axis};
  }

 private:
  bool is_crossed_;  ///< else the choice is of the other variables
  FormCourse before_, after_;
  LowestValue step_;  ///< from the one to the other
};

/// How the condition of a choice changes along a variable.
enum class Switching { never, on, off };

/// How the condition of a choice changes in all ranges; empty if it may change twice.
std::optional<Switching> switching_of(const Symbolic& choice, const FormInputs& inputs,
                                      std::size_t variable) {
  const Symbolic difference = choice.part(1) - choice.part(0);
  LowestValue value = inputs.lowest_of(difference), slope = inputs.slope_of(difference, variable);
  bool rises = true, falls = true;
  for (const StudyBox& corner : corners_of(inputs.ranges)) {
    const LowestOnBox values = value.on(corner);
    if (values.may_have_pole || values.may_jump) return std::nullopt;
    const Interval slopes = slope.on(corner).values;
    rises = rises && is_never_negative(slopes);
    falls = falls && is_never_positive(slopes);
  }
  if (rises && falls) return Switching::never;
  if (rises) return Switching::on;
  if (falls) return Switching::off;
  return std::nullopt;
}

std::optional<SwitchedCourse> switched_course(const Symbolic& form, const FormInputs& inputs,
                                              std::size_t variable) {
  std::vector<Symbolic> choices;
  append_choices(form, choices);
  if (choices.size() != 1) return std::nullopt;
  const auto switching = switching_of(choices.front(), inputs, variable);
  if (!switching) return std::nullopt;
  const Symbolic chosen = side_of_choice(form, 2), other = side_of_choice(form, 3);
  const bool is_off = *switching == Switching::off;
  return SwitchedCourse(is_off ? chosen : other, is_off ? other : chosen, *switching != Switching::never,
                        inputs, variable);
}

/// Proves that along every line of a variable all falls of a form add up to no more than the slack.
///
/// On a box it falls by no more than the width of the box times the wrong part of the slope; where it has no
/// slope, by no more than the width of its values. A form with one choice is several forms where the choice
/// may switch. If the condition rises or falls along the variable, it switches once: then the falls of both
/// sides count, and the step down between them. If the variable is not in the condition, the larger fall
/// counts.
ShapeProof prove_never_falls(const Symbolic& form, const FormInputs& inputs, std::size_t variable,
                             double slack, const Checkpoint& checkpoint) {
  FormCourse course(form, inputs, variable);
  std::optional<SwitchedCourse> switched = switched_course(form, inputs, variable);
  const auto rule = [&](const StudyBox& box) {
    Fall fall = course.largest_fall(box);
    if (fall.may_jump && switched) {
      const Fall by_sides = switched->largest_fall(box);
      if (by_sides.amount < fall.amount) fall = by_sides;
    }
    Violation result{fall.amount, fall.axis};
    if (result.amount <= 0) return result;
    // Along one edge of the box.
    StudyBox from = box;
    for (Stretch& side : from) side.upper = side.lower;
    StudyBox to = from;
    to[variable].lower = to[variable].upper = box[variable].upper;
    if (lower_end(course.values_on(from) - course.values_on(to)) > slack)
      result.place = place_in(from, inputs.ranges);
    return result;
  };
  return prove_on_boxes(inputs.ranges, rule, lines_above(slack, variable, inputs.ranges), checkpoint);
}

/// The error at one place against a slack.
ShapeProof judge_place(EnclosedError& error, const std::vector<double>& place, double slack) {
  const Interval difference = error.at(place);
  if (largest_magnitude_in(difference) <= slack) return {Proof::proven, {}, 1};
  if (smallest_magnitude_in(difference) > slack) return {Proof::refuted, place, 1};
  return {Proof::open, place, 1, "a proof finds no finite bound"};
}

/// Proves that |error| is within a slack where one of several variables is at an end: there it is a constant.
ShapeProof prove_edge(ReadStudy study, std::vector<Interval> parameters, std::size_t axis, double end,
                      double slack, const Checkpoint& checkpoint) {
  study.parameters.push_back(study.axes[axis].variable);
  parameters.emplace_back(end);
  study.axes.erase(study.axes.begin() + static_cast<std::ptrdiff_t>(axis));
  EnclosedError error(study, parameters);
  const auto rule = [&](const StudyBox& box) {
    const BoxBound found = error.bound_on(box, slack);
    Violation result{found.bound, found.axis};
    if (result.amount > slack && smallest_magnitude_in(error.at(found.place)) > slack) {
      result.place = found.place;
      result.place->insert(result.place->begin() + static_cast<std::ptrdiff_t>(axis), end);
    }
    return result;
  };
  return prove_on_boxes(error.ranges(), rule, each_above(slack), checkpoint,
                        error.has_integrals() ? most_edge_boxes_of_integrals : most_shape_boxes);
}

}  // namespace

ShapeProof prove_exact(const StudySubject& subject, std::size_t axis, double end, double slack,
                       const Checkpoint& checkpoint) {
  StudySubject plain = subject;
  plain.study.weight = "1";
  plain.study.error = Error::absolute;
  if (plain.study.rows) return without_boxes("the target is known at the rows alone");
  if (const std::string fault = fault_of(plain); !fault.empty()) return without_boxes(fault);
  const ReadStudy study = read_formulas(plain.study);
  std::vector<Interval> parameters = parameters_of(plain, study);
  if (study.axes.size() > 1) return prove_edge(study, std::move(parameters), axis, end, slack, checkpoint);
  EnclosedError error(study, parameters);
  return judge_place(error, {end}, slack);
}

ShapeProof prove_shape(const StudySubject& subject, const Constraints& constraint, double scale,
                       std::size_t variable, const Checkpoint& checkpoint) {
  if (!constraint.at_least && !constraint.at_most && !constraint.monotone) {
    if (constraint.exact_at.empty()) return {};
    return prove_exact(subject, variable, constraint.exact_at.front(), exact_slack * scale, checkpoint);
  }
  const ReadStudy study = read_formulas(subject.study);
  if (integral_depth(study.form) > 0) return without_boxes("the form has an integral");
  const FormInputs inputs = inputs_of_form(subject, study);
  const double slack = shape_slack * scale;
  if (constraint.at_least) return prove_bound(study.form, inputs, *constraint.at_least, slack, checkpoint);
  if (constraint.at_most) return prove_bound(-study.form, inputs, -*constraint.at_most, slack, checkpoint);
  return prove_never_falls(constraint.monotone == Course::rises ? study.form : -study.form, inputs, variable,
                           slack, checkpoint);
}

}  // namespace shadefit
