#include "fit/study_proof/prove_shape.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fit/proof/constants.hpp"
#include "fit/proof/enclosed_constant.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study_proof/cut_boxes.hpp"
#include "fit/study_proof/enclosed_error.hpp"
#include "fit/study_proof/lowest_value.hpp"
#include "fit/study_proof/prove_course.hpp"
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

FormInputs inputs_of_form(const StudySubject& subject, const ReadStudy& study) {
  FormInputs inputs{.names = {}, .ranges = {}, .parameters = parameters_of(subject, study)};
  for (const StudyAxis& axis : study.axes) {
    inputs.names.push_back(axis.variable);
    inputs.ranges.push_back({axis.lower, axis.upper});
  }
  inputs.names.insert(inputs.names.end(), study.parameters.begin(), study.parameters.end());
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
