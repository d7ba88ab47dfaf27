#include "fit/study_proof/prove_course.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/proof/interval_ends.hpp"
#include "fit/study_proof/cut_boxes.hpp"
#include "fit/tape/graph.hpp"

namespace shadefit {
namespace {

/// Adds the choices of a formula to a list, equal ones once.
void append_choices(const Symbolic& formula, std::vector<Symbolic>& choices) {
  const auto is_same = [&](const Symbolic& other) { return to_text(other) == to_text(formula); };
  if (formula.kind() == Symbolic::Kind::choice && std::none_of(choices.begin(), choices.end(), is_same))
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

}  // namespace

LowestValue FormInputs::lowest_of(const Symbolic& formula) const {
  Graph graph(names);
  const int node = graph.add(formula);
  return {std::move(graph), node, ranges, parameters};
}

LowestValue FormInputs::slope_of(const Symbolic& formula, std::size_t variable) const {
  Graph graph(names);
  const int node = graph.derivative(graph.add(formula), variable);
  return {std::move(graph), node, ranges, parameters};
}

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

}  // namespace shadefit
