#include "fit/bounds/enclosed_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// The name of a variable for an integral. A formula cannot use it, because names have no space.
std::string name_of_integral(std::size_t i) {
  return "integral " + std::to_string(i);
}

/// A formula with variables in place of its integrals, which are added to a list.
Symbolic separated(const Symbolic& e, std::vector<Symbolic>& integrals) {
  using Kind = Symbolic::Kind;
  if (e.kind() == Kind::integral) {
    const auto is_same = [text = to_text(e)](const Symbolic& other) { return to_text(other) == text; };
    const auto found = std::ranges::find_if(integrals, is_same);
    const auto i = static_cast<std::size_t>(found - integrals.begin());
    if (found == integrals.end()) integrals.push_back(e);
    return Symbolic::variable(name_of_integral(i));
  }
  std::vector<Symbolic> parts;
  for (const Symbolic& part : e.parts()) parts.push_back(separated(part, integrals));
  return parts.empty() ? e : e.with_parts(std::move(parts));
}

/// What is in both of two enclosures of the same numbers.
Interval narrowed(const Interval& usual, const Interval& limited) {
  return is_bounded(usual) ? shared_by(usual, limited) : limited;
}

/// Where a denominator of the error, or the operand of a logarithm, is 0; empty of several variables.
std::vector<double> poles_of(const ReadStudy& study) {
  std::vector<double> places;
  if (study.axes.size() > 1) return places;
  for (const Hinge& hinge : hinges_of(error_formula(study))) {
    if (!hinge.is_pole || free_variables(hinge.part) != std::set{study.axes.front().variable}) continue;
    const StudyAxis& axis = study.axes.front();
    // exp(x) - 1 is 0 in double where x is rounding: the place is 0.
    const double rounding = 1e-15 * (axis.upper - axis.lower);
    for (const double zero : zeros_of(hinge.part, axis))
      places.push_back(std::abs(zero) < rounding ? 0 : zero);
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// The terms of a sum by their texts, and how often each is in it, less how often it is subtracted.
void collect_terms(const Symbolic& e, int times, std::map<std::string, std::pair<Symbolic, int>>& terms) {
  using Kind = Symbolic::Kind;
  if (e.kind() == Kind::add || e.kind() == Kind::subtract) {
    collect_terms(e.part(0), times, terms);
    collect_terms(e.part(1), e.kind() == Kind::add ? times : -times, terms);
  } else {
    terms.emplace(to_text(e), std::pair(e, 0)).first->second.second += times;
  }
}

/// The inputs of the error: the variables, its integrals, the parameters.
std::vector<std::string> inputs_of(const ReadStudy& study, std::size_t integrals) {
  std::vector<std::string> inputs = node_variables(study);
  for (std::size_t i = 0; i < integrals; ++i) inputs.push_back(name_of_integral(i));
  inputs.insert(inputs.end(), study.parameters.begin(), study.parameters.end());
  return inputs;
}

}  // namespace

ReadStudy without_equal_terms(const ReadStudy& study, const Constants& parameters) {
  if (study.residual) return study;
  const Symbolic with_decimals = evaluate<Symbolic>(study.form, [&](const std::string& name) {
    const auto found = std::ranges::find(parameters, name, &Constants::value_type::first);
    const bool is_decimal =
        found != parameters.end() && found->second.find_first_not_of("0123456789.") == std::string::npos;
    return is_decimal ? Symbolic::number(found->second) : Symbolic::variable(name);
  });
  std::map<std::string, std::pair<Symbolic, int>> terms;
  collect_terms(with_decimals, 1, terms);
  collect_terms(study.target, -1, terms);
  if (std::ranges::none_of(terms, [](const auto& term) { return term.second.second == 0; })) return study;
  ReadStudy result = study;
  result.form = result.target = Symbolic::number("0");
  for (const auto& [text, term] : terms)
    if (term.second != 0)
      result.form = result.form + Symbolic::number(std::to_string(term.second)) * term.first;
  result.weight = error_factor(study);
  result.error = Error::absolute;
  return result;
}

EnclosedError::EnclosedError(const ReadStudy& study, std::span<const Interval> parameters,
                             KnownIntegrals known) {
  for (const StudyAxis& axis : study.axes) ranges_.push_back({axis.lower, axis.upper});
  std::vector<Symbolic> integrals;
  const Symbolic error = separated(error_formula(study), integrals);
  for (const Symbolic& integral : integrals) integrals_.push_back(known.of(study, integral, parameters));
  Graph graph(inputs_of(study, integrals.size()));
  std::vector<int> value{graph.add(error)}, slopes, curvatures;
  jumps_ = Jumps(graph);
  if (const std::vector<double> places = poles_of(study); !places.empty() && integrals.empty())
    limits_.emplace(graph, value.front(), places, parameters);
  for (std::size_t i = 0; i < study.axes.size() + integrals.size(); ++i)
    slopes.push_back(graph.derivative(value.front(), i));
  kinks_ = Jumps(graph);
  for (std::size_t i = 0; i < slopes.size() && study.axes.size() == 1; ++i)
    for (std::size_t k = 0; k <= i; ++k) curvatures.push_back(graph.derivative(slopes[i], k));
  for (const int node : kinks_.deciding_nodes()) slopes.push_back(node);
  for (const int node : jumps_.deciding_nodes()) value.push_back(node);
  value_.emplace(Tape(graph, value), parameters);
  slopes_.emplace(Tape(graph, slopes), parameters);
  curvatures_.emplace(Tape(graph, curvatures), parameters);
}

/// The variables, then the integrals there.
std::vector<Interval> EnclosedError::with_integrals(std::vector<Interval> variables) {
  const std::size_t count = variables.size();
  for (const auto& integral : integrals_)
    variables.push_back(integral->value(std::span(variables).first(count)));
  return variables;
}

const Interval& EnclosedError::value_for(std::vector<Interval> variables) {
  value_->run(with_integrals(std::move(variables)));
  return value_->output(0);
}

std::vector<Interval> EnclosedError::slopes_for(std::vector<Interval> variables) {
  const std::size_t count = variables.size();
  variables = with_integrals(std::move(variables));
  slopes_->run(variables);
  std::vector<Interval> slopes;
  for (std::size_t i = 0; i < count; ++i) slopes.push_back(slopes_->output(i));
  for (std::size_t k = 0; k < integrals_.size(); ++k) {
    const std::vector<Interval> inner = integrals_[k]->slopes(std::span(variables).first(count));
    for (std::size_t i = 0; i < count; ++i) slopes[i] = slopes[i] + slopes_->output(count + k) * inner[i];
  }
  return slopes;
}

/// The second derivative by the only variable. Each integral k is a function of it: the error is e(x, k(x)).
Interval EnclosedError::curvature_for(const std::vector<Interval>& variables) {
  std::vector<Interval> by_variable{Interval(1)};  // of x and of the integrals
  Interval sum(0);
  for (const auto& integral : integrals_) by_variable.push_back(integral->slopes(variables).front());
  const std::vector<Interval> inputs = with_integrals(variables);
  curvatures_->run(inputs);
  std::size_t pair = 0;
  for (std::size_t i = 0; i < by_variable.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const Interval term = curvatures_->output(pair++) * by_variable[i] * by_variable[k];
      sum = sum + (k < i ? Interval(Interval(2) * term) : term);
    }
  }
  slopes_->run(inputs);
  for (std::size_t k = 0; k < integrals_.size(); ++k)
    sum = sum + slopes_->output(1 + k) * integrals_[k]->curvature(variables);
  return sum;
}

std::vector<Interval> EnclosedError::slopes_on(const StudyBox& box) {
  const std::vector<Interval> numbers = numbers_on(box, ranges_);
  std::vector<Interval> slopes = slopes_for(numbers);
  const auto limited = limits_ ? limits_->on(numbers.front()) : std::nullopt;
  if (limited) slopes[0] = narrowed(slopes[0], limited->slope);
  if (box.size() > 1 || !is_bounded(slopes[0]) || has_one_sign(slopes[0])) return slopes;
  if (kinks_.may_happen(*slopes_, 1 + integrals_.size())) return slopes;
  Interval curvature = curvature_for(numbers);
  if (limited) curvature = narrowed(curvature, limited->curvature);
  if (!is_bounded(curvature)) return slopes;
  const Stretch middle = middle_of(box[0]);
  const Interval in_middle = slopes_for(numbers_on({middle}, ranges_)).front();
  const Interval moved =
      in_middle + curvature * (span_of(box[0].lower, box[0].upper) - Interval(middle.lower));
  if (is_bounded(moved)) slopes[0] = shared_by(slopes[0], moved);
  return slopes;
}

Interval EnclosedError::at(std::span<const double> place) {
  return value_or_limit({place.begin(), place.end()});
}

/// The value at a place.
Interval EnclosedError::value_or_limit(const std::vector<Interval>& place) {
  const Interval value = value_for(place);
  if (is_bounded(value) || !limits_) return value;
  return limits_->at(place.front()).value_or(value);
}

/// A bound on a stretch on which the formula has none, x log(x) from x = 0: by its values at the ends if it
/// rises or falls, and else none.
double EnclosedError::bound_by_ends(const Stretch& stretch) {
  const Interval slope = slopes_for(numbers_on({stretch}, ranges_)).front();
  if (!is_never_negative(slope) && !is_never_positive(slope)) return std::numeric_limits<double>::infinity();
  double bound = 0;
  for (const double end : {stretch.lower, stretch.upper}) {
    const Stretch place{stretch.is_from_upper, end, end};
    bound = std::fmax(bound, largest_magnitude_in(value_or_limit(numbers_on({place}, ranges_))));
  }
  return bound;
}

BoxBound EnclosedError::bound_on(const StudyBox& box, double enough) {
  const std::vector<Interval> numbers = numbers_on(box, ranges_);
  Interval value = value_for(numbers);
  const auto limited = limits_ ? limits_->on(numbers.front()) : std::nullopt;
  if (limited) value = narrowed(value, limited->value);
  const double natural = largest_magnitude_in(value);
  BoxBound result{natural, widest_axis(box, ranges_), place_in(box, ranges_)};
  if (limits_ && !is_bounded(value)) result.bound = bound_by_ends(box.front());
  if (natural <= enough || !is_bounded(value) || jumps_.may_happen(*value_, 1)) return result;

  const std::vector<Interval> slopes = slopes_on(box);
  // Where the value is largest and smallest, as far as the slopes tell, and the rest of the sum.
  StudyBox high = box, low = box;
  Interval rest(0);
  double widest_term = -1;
  const auto cut_if_wider = [&](std::size_t axis, double width) {
    if (!(width > widest_term)) return;
    widest_term = width;
    result.axis = axis;
  };
  const StudyBox middle = middle_of_all(box);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Interval& slope = slopes[i];
    const double from = box[i].lower, to = box[i].upper;
    if (!is_bounded(slope)) {
      // Next to a root, for example: the width of the value along this variable replaces the term.
      StudyBox line = middle;
      line[i] = box[i];
      cut_if_wider(i, width_of(value_for(numbers_on(line, ranges_))));
      continue;
    }
    if (is_never_negative(slope) || is_never_positive(slope)) {
      const bool rises = is_never_negative(slope);
      high[i].lower = high[i].upper = rises ? to : from;
      low[i].lower = low[i].upper = rises ? from : to;
      continue;
    }
    high[i] = low[i] = middle_of(box[i]);
    const Interval term = slope * (span_of(from, to) - Interval(high[i].lower));
    rest = rest + term;
    cut_if_wider(i, width_of(term));
  }
  const Interval top = value_or_limit(numbers_on(high, ranges_)) + rest,
                 bottom = value_or_limit(numbers_on(low, ranges_)) + rest;
  if (!is_bounded(top) || !is_bounded(bottom)) return result;
  const bool is_top = largest_magnitude_in(top) >= largest_magnitude_in(bottom);
  result.place = place_in(is_top ? high : low, ranges_);
  result.bound = std::fmin(natural, std::fmax(upper_end(top), -lower_end(bottom)));
  return result;
}

}  // namespace shadefit
