#include "fit/study_proof/enclosed_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "fit/proof/interval_ends.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string_view name_of(const GraphNode& node) {
  const auto index = static_cast<std::size_t>(node.index);
  if (node.operation == Operation::function) return functions_of_one<double>[index].name;
  return node.operation == Operation::function_of_two ? functions_of_two<double>[index].name : "";
}

/// Whether an operation is not continuous in its operands. Poles need no care: there values or slopes are
/// unbounded.
bool can_jump(const GraphNode& node) {
  const std::string_view name = name_of(node);
  return node.operation == Operation::choice || name == "sign" || name == "floor" || name == "atan2";
}

/// How many operands decide on which side of its jump an operation is.
std::size_t deciding(const GraphNode& node) {
  return node.operation == Operation::function ? 1 : 2;
}

bool is_one_number(const Interval& x) {
  return is_bounded(x) && lower_end(x) == upper_end(x);
}

/// Whether an operation may jump for operands in `a` and `b`.
bool jumps_on(const GraphNode& node, const Interval& a, const Interval& b) {
  const std::string_view name = name_of(node);
  if (name == "sign") return !is_one_number(signum(a));
  if (name == "floor") return !is_one_number(floor(a));
  // The angle jumps at y = 0, x <= 0, and is continuous on the side of y > 0.
  if (name == "atan2") return !(is_never_negative(a) || upper_end(a) < 0 || lower_end(b) > 0);
  return less(a, b) == Certainty::unknown;
}

}  // namespace

IntervalProgram::IntervalProgram(const Tape& tape, std::span<const Interval> parameters)
    : tape_(tape), values_(tape_.register_count() + tape_.input_count() - parameters.size()) {
  values_.insert(values_.end(), parameters.begin(), parameters.end());
  for (const Interval& constant : tape_.constants<Interval>()) values_.push_back(constant);
  for (Interval& value : values_) table_.push_back(&value);
  for (std::size_t i = 0; i < tape_.register_count(); ++i) registers_.push_back(&values_[i]);
}

void IntervalProgram::run(std::span<const Interval> variables) {
  std::copy(variables.begin(), variables.end(),
            values_.begin() + static_cast<std::ptrdiff_t>(tape_.register_count()));
  tape_.run_over<Interval>(table_, registers_, 1);
}

/// The tapes of the value and of the slopes by the variables.
struct EnclosedError::Programs {
  explicit Programs(const ReadStudy& study) : graph(inputs_of(study)) {
    const int error = graph.add(error_formula(study));
    value = {error};
    for (const GraphNode& node : graph.nodes()) {
      if (!can_jump(node)) continue;
      jumps.push_back(node);
      for (std::size_t i = 0; i < deciding(node); ++i) value.push_back(node.operands[i]);
    }
    for (std::size_t i = 0; i < study.axes.size(); ++i) slopes.push_back(graph.derivative(error, i));
    for (std::size_t i = 0; i < graph.inputs().size(); ++i) given.push_back(graph.add(input(i)));
  }

  static std::vector<std::string> inputs_of(const ReadStudy& study) {
    std::vector<std::string> inputs;
    for (const StudyAxis& axis : study.axes) inputs.push_back(axis.variable);
    inputs.insert(inputs.end(), study.parameters.begin(), study.parameters.end());
    return inputs;
  }
  Symbolic input(std::size_t i) const { return Symbolic::variable(graph.inputs()[i]); }
  Tape tape(std::span<const int> outputs) const { return {graph, outputs, given}; }

  Graph graph;
  std::vector<int> value, slopes, given;
  std::vector<GraphNode> jumps;
};

EnclosedError::EnclosedError(const ReadStudy& study, std::span<const Interval> parameters)
    : EnclosedError(study, parameters, Programs(study)) {}

EnclosedError::EnclosedError(const ReadStudy& study, std::span<const Interval> parameters, Programs programs)
    : jumps_(std::move(programs.jumps)),
      value_(programs.tape(programs.value), parameters),
      slopes_(programs.tape(programs.slopes), parameters) {
  for (const StudyAxis& axis : study.axes) ranges_.push_back({axis.lower, axis.upper});
}

Interval EnclosedError::at(std::span<const double> place) {
  const std::vector<Interval> variables(place.begin(), place.end());
  value_.run(variables);
  return value_.output(0);
}

bool EnclosedError::may_jump() const {
  std::size_t next = 1;
  for (const GraphNode& node : jumps_) {
    const Interval& a = value_.output(next);
    const Interval& b = value_.output(next + deciding(node) - 1);
    next += deciding(node);
    if (jumps_on(node, a, b)) return true;
  }
  return false;
}

const Interval& EnclosedError::value_on(const StudyBox& box) {
  std::vector<Interval> variables;
  for (std::size_t i = 0; i < box.size(); ++i) variables.push_back(numbers_of(box[i], ranges_[i]));
  value_.run(variables);
  return value_.output(0);
}

/// The variable with the largest part of its range in a box.
std::size_t EnclosedError::widest(const StudyBox& box) const {
  std::size_t widest = 0;
  const auto share = [&](std::size_t i) {
    return (box[i].upper - box[i].lower) / (ranges_[i].upper / 2 - ranges_[i].lower / 2);
  };
  for (std::size_t i = 1; i < box.size(); ++i) {
    if (share(i) > share(widest)) widest = i;
  }
  return widest;
}

BoxBound EnclosedError::bound_on(const StudyBox& box, double enough) {
  const Interval value = value_on(box);
  const double natural = largest_magnitude_in(value);
  BoxBound result{natural, widest(box), place_in(box, ranges_), natural};
  if (natural <= enough || !is_bounded(value) || may_jump()) return result;

  std::vector<Interval> variables;
  for (std::size_t i = 0; i < box.size(); ++i) variables.push_back(numbers_of(box[i], ranges_[i]));
  slopes_.run(variables);
  // The places of the largest and of the smallest value, as far as the slopes tell, and the rest of the sum.
  StudyBox high = box, low = box;
  Interval rest(0);
  double widest_term = 0;
  bool has_rest = false;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Interval& slope = slopes_.output(i);
    if (!is_bounded(slope)) continue;
    const double from = box[i].lower, to = box[i].upper;
    if (is_never_negative(slope) || is_never_positive(slope)) {
      const bool rises = is_never_negative(slope);
      high[i].lower = high[i].upper = rises ? to : from;
      low[i].lower = low[i].upper = rises ? from : to;
      continue;
    }
    high[i] = low[i] = middle_of(box[i]);
    const Interval term = slope * (span_of(from, to) - Interval(high[i].lower));
    rest = rest + term;
    if (const double width = width_of(term); !has_rest || width > widest_term) {
      widest_term = width;
      result.axis = i;
    }
    has_rest = true;
  }
  const Interval top = value_on(high) + rest, bottom = value_on(low) + rest;
  if (!is_bounded(top) || !is_bounded(bottom)) return result;
  const bool is_top = largest_magnitude_in(top) >= largest_magnitude_in(bottom);
  result.place = place_in(is_top ? high : low, ranges_);
  result.bound = std::fmin(natural, std::fmax(upper_end(top), -lower_end(bottom)));
  result.hope = result.bound;
  return result;
}

}  // namespace shadefit
