#include "fit/bounds/study_integral.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "fit/bounds/jumps.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/scalars/taylor.hpp"
#include "fit/support/memory.hpp"

namespace shadefit {
namespace {

constexpr int integral_order = 16;
using Series = Taylor<integral_order, Interval>;

/// The most panels of an integral. The panel next to a root is halved about 40 times.
constexpr std::size_t most_inner_panels = 64;

/// A panel is not cut if its remainder adds less than this share of the integral, or of the width that the
/// intervals of the variables cause.
constexpr double negligible = 1e-20, small_beside_width = 1e-3;

/// The name of the variable in [0, 1]. A formula cannot use it, because names have no space.
const std::string unit_variable = "unit variable";

/// length * body(lower + length s), whose integral over s from 0 to 1 is the integral.
Symbolic on_unit_interval(const Symbolic& integral) {
  const Symbolic &lower = integral.part(1), length = integral.part(2) - lower;
  const Symbolic place = lower + length * Symbolic::variable(unit_variable);
  return length * evaluate<Symbolic>(integral.part(0), [&](const std::string& name) {
           return name == integral.name() ? place : Symbolic::variable(name);
         });
}

std::vector<Series> as_series(std::span<const Interval> constants) {
  return {constants.begin(), constants.end()};
}

/// The integral of coefficient * s^j over [-radius, radius], j even.
Interval moment(const Interval& coefficient, double radius, int j) {
  return Interval(2) * coefficient * power(Interval(radius), j + 1) / Interval(j + 1);
}

}  // namespace

/// The integrals of the outputs of one tape.
class StudyIntegral::Panels {
 public:
  /// The outputs of `range` are `count` bodies and the deciding nodes of their jumps; those of `series` are
  /// the bodies.
  Panels(std::size_t count, const Tape& range, const Tape& series, Jumps jumps,
         std::span<const Interval> parameters)
      : count_(count),
        range_(range, parameters),
        series_(series, as_series(parameters)),
        jumps_(std::move(jumps)) {}

  /// A bound on a box asks for the same integrals several times, neighbours share an end, and other proofs
  /// come to the same boxes.
  std::vector<Interval> of(std::span<const Interval> variables) {
    return known_.get({variables.begin(), variables.end()}, [&] { return computed(variables); });
  }

 private:
  struct BoxesBefore {
    bool operator()(const std::vector<Interval>& a, const std::vector<Interval>& b) const {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), comes_before);
    }
  };

  std::vector<Interval> computed(std::span<const Interval> variables) {
    std::vector<Panel> panels{panel(variables, 0, 1)};
    while (panels.size() < most_inner_panels) {
      const auto worst = std::ranges::max_element(
          panels, {}, [](const Panel& p) { return std::pair(p.excess, p.upper - p.lower); });
      if (worst->excess <= allowed(panels)) break;
      const Panel cut = *worst;
      const double middle = cut.lower + (cut.upper - cut.lower) / 2;
      *worst = panel(variables, cut.lower, middle);
      panels.push_back(panel(variables, middle, cut.upper));
    }
    std::vector<Interval> sums(count_, Interval(0));
    for (const Panel& part : panels) {
      for (std::size_t i = 0; i < count_; ++i) sums[i] = sums[i] + part.values[i];
    }
    return sums;
  }

  struct Panel {
    double lower, upper;  ///< exact: sums of powers of two
    std::vector<Interval> values;
    double excess;  ///< the part of the width that a cut reduces
    double width;   ///< the part that it does not reduce
  };

  /// An excess up to this needs no cut.
  double allowed(const std::vector<Panel>& panels) const {
    double width = 0, magnitude = 0;
    for (const Panel& panel : panels) {
      width += panel.width;
      for (const Interval& value : panel.values)
        magnitude = std::fmax(magnitude, std::fmin(largest_magnitude_in(value), 1 / negligible));
    }
    return std::fmax(small_beside_width * width, negligible * magnitude);
  }

  /// By series if they have a bound and the bodies do not jump, otherwise by the range of the bodies.
  Panel panel(std::span<const Interval> variables, double lower, double upper) {
    if (!jumps_.empty()) {
      run_range(variables, lower, upper);
      if (jumps_.may_happen(range_, count_)) return by_range(lower, upper);
    }
    if (auto result = by_series(variables, lower, upper)) return *result;
    run_range(variables, lower, upper);
    return by_range(lower, upper);
  }

  std::optional<Panel> by_series(std::span<const Interval> variables, double lower, double upper) {
    Panel result{lower, upper, {}, 0, 0};
    const double middle = lower + (upper - lower) / 2, radius = (upper - lower) / 2;
    std::vector<Interval> rest;
    run_series(variables, Series::variable(span_of(lower, upper)));
    for (std::size_t i = 0; i < count_; ++i)
      rest.push_back(moment(series_.output(i)[integral_order], radius, integral_order));
    if (!std::ranges::all_of(rest, is_bounded)) return std::nullopt;
    run_series(variables, Series::variable(Interval(middle)));
    for (std::size_t i = 0; i < count_; ++i) {
      Interval sum(0);
      for (int j = 0; j < integral_order; j += 2) sum = sum + moment(series_.output(i)[j], radius, j);
      result.width = std::fmax(result.width, width_of(sum));
      result.excess = std::fmax(result.excess, width_of(rest[i]));
      result.values.push_back(sum + rest[i]);
    }
    if (!std::ranges::all_of(result.values, is_bounded)) return std::nullopt;
    return result;
  }

  /// After `run_range`.
  Panel by_range(double lower, double upper) const {
    Panel result{lower, upper, {}, 0, 0};
    for (std::size_t i = 0; i < count_; ++i) {
      const Interval value = Interval(upper - lower) * range_.output(i);
      result.values.push_back(is_bounded(value) ? value : any_number());
      result.excess = std::fmax(result.excess, width_of(result.values.back()));
    }
    return result;
  }

  void run_range(std::span<const Interval> variables, double lower, double upper) {
    std::vector<Interval> places{span_of(lower, upper)};
    places.insert(places.end(), variables.begin(), variables.end());
    range_.run(places);
  }

  void run_series(std::span<const Interval> variables, const Series& unit) {
    std::vector<Series> places{unit};
    for (const Interval& variable : variables) places.push_back(Series(variable));
    series_.run(places);
  }

  std::size_t count_;
  TapeProgram<Interval> range_;
  TapeProgram<Series> series_;
  Jumps jumps_;
  Memory<std::vector<Interval>, std::vector<Interval>, BoxesBefore> known_;  ///< by the variables
};

StudyIntegral::StudyIntegral(const ReadStudy& study, const Symbolic& integral,
                             std::span<const Interval> parameters) {
  std::vector<std::string> inputs = formula_inputs(study);
  inputs.insert(inputs.begin(), unit_variable);
  Graph graph(inputs);
  const int body = graph.add(on_unit_interval(integral));
  const Jumps jumps(graph);
  std::vector<int> bodies{body}, bodies_and_jumps{body}, by_variable;
  for (const int node : jumps.deciding_nodes()) bodies_and_jumps.push_back(node);
  for (std::size_t i = 0; i < study.axes.size(); ++i) by_variable.push_back(graph.derivative(body, 1 + i));
  const bool is_smooth = Jumps(graph).empty();  // no slope of a kink jumps
  const std::vector<int> twice{graph.derivative(by_variable.front(), 1)};
  const auto tape = [&](const std::vector<int>& outputs) { return Tape(graph, outputs); };
  value_ = std::make_unique<Panels>(bodies.size(), tape(bodies_and_jumps), tape(bodies), jumps, parameters);
  if (!jumps.empty()) return;
  slopes_ =
      std::make_unique<Panels>(by_variable.size(), tape(by_variable), tape(by_variable), jumps, parameters);
  if (is_smooth) curvature_ = std::make_unique<Panels>(1, tape(twice), tape(twice), jumps, parameters);
}

StudyIntegral::~StudyIntegral() = default;

Interval StudyIntegral::value(std::span<const Interval> variables) {
  return value_->of(variables).front();
}

std::vector<Interval> StudyIntegral::slopes(std::span<const Interval> variables) {
  return slopes_ ? slopes_->of(variables) : std::vector<Interval>(variables.size(), any_number());
}

Interval StudyIntegral::curvature(std::span<const Interval> variables) {
  return curvature_ ? curvature_->of(variables).front() : any_number();
}

std::shared_ptr<StudyIntegral> KnownIntegrals::of(const ReadStudy& study, const Symbolic& integral,
                                                  std::span<const Interval> parameters) {
  if (contains_any(integral, study.parameters))
    return std::make_shared<StudyIntegral>(study, integral, parameters);
  std::shared_ptr<StudyIntegral>& known = (*known_)[to_text(integral)];
  if (known == nullptr) {
    ReadStudy plain = study;
    plain.parameters.clear();
    known = std::make_shared<StudyIntegral>(plain, integral, std::span<const Interval>{});
  }
  return known;
}

}  // namespace shadefit
