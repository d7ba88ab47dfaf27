#include "fit/study/study_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/hinges.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/scalars/rounded_interval.hpp"
#include "fit/study/axis_nodes.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// How close to a root or a logarithm the nodes go.
constexpr int power_at_root = 8;
/// A formula of shading has fewer edges. Each adds a panel.
constexpr std::size_t most_study_edges = 64;

/// A formula along its last variable. The variables before it have given values.
class HingeCurve {
 public:
  HingeCurve(const Symbolic& formula, std::span<const StudyAxis> axes)
      : program_(tape_of(formula, last_first(axes), 1), {}),
        enclosed_(program_.tape(), {}),
        values_(axes.size()),
        is_smooth_(hinges_of(formula).empty()) {}

  /// Gives the variables before the last their values.
  void set_before(std::span<const long double> before) {
    std::copy(before.begin(), before.end(), values_.begin() + 1);
  }

  double value(double x) {
    values_.front() = x;
    program_.run(values_);
    return program_.output(0);
  }
  double slope(double x) {
    value(x);
    return program_.output(1);
  }
  /// What enclosures tell of a range.
  struct Range {
    bool may_be_zero;  ///< whether some value is 0 or rounding
    bool is_monotone;  ///< certainly
  };
  Range range(double lower, double upper) {
    std::vector<Enclosure> inputs(values_.begin(), values_.end());
    inputs.front() = Enclosure(lower, upper);
    enclosed_.run(inputs);
    const auto has_zero = [&](std::size_t i) {
      return enclosed_.output(i).lower() <= 0 && 0 <= enclosed_.output(i).upper();
    };
    return {has_zero(0), is_smooth_ && !has_zero(1)};
  }

 private:
  using Enclosure = RoundedInterval<OutwardArithmetic>;

  static std::vector<std::string> last_first(std::span<const StudyAxis> axes) {
    std::vector<std::string> names{axes.back().variable};
    for (const StudyAxis& axis : axes.first(axes.size() - 1)) names.push_back(axis.variable);
    return names;
  }

  TapeProgram<double> program_;
  TapeProgram<Enclosure> enclosed_;
  std::vector<double> values_;
  bool is_smooth_;
};

/// Evenly spaced places, and powers of two towards both ends.
std::vector<double> places_on(double lower, double upper) {
  constexpr int count = 512, first_power = 10, last_power = 50;
  std::vector<double> places{lower};
  for (int i = last_power - 1; i >= first_power; --i)
    places.push_back(lower + (upper - lower) * std::ldexp(1.0, -i));
  for (int i = 1; i < count; ++i) places.push_back(lower + (upper - lower) * i / count);
  for (int i = first_power; i < last_power; ++i)
    places.push_back(upper - (upper - lower) * std::ldexp(1.0, -i));
  places.push_back(upper);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// The place between two neighbours where a predicate changes.
template <class Predicate>
double bisected(double low, double high, const Predicate& predicate) {
  const bool at_low = predicate(low);
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return high;
    (predicate(middle) == at_low ? low : high) = middle;
  }
}

/// Adds the zeros of a hinge as edges. `part` is the formula of the hinge.
void append_zeros(const Hinge& hinge, HingeCurve& part, const StudyAxis& axis,
                  std::vector<StudyEdge>& edges) {
  const auto [may_be_zero, is_monotone] = part.range(axis.lower, axis.upper);
  if (!may_be_zero) return;
  // The sign of a monotone part at both ends tells whether it has a zero, and bisection finds it.
  const bool has_ends_only =
      is_monotone && std::isfinite(part.value(axis.lower)) && std::isfinite(part.value(axis.upper));
  const std::vector<double> places =
      has_ends_only ? std::vector{axis.lower, axis.upper} : places_on(axis.lower, axis.upper);
  std::vector<double> values;
  double largest = 0;
  for (const double x : places) {
    values.push_back(part.value(x));
    if (std::isfinite(values.back())) largest = std::max(largest, std::abs(values.back()));
  }
  const int power = hinge.is_root ? power_at_root : 1;
  // The zero that is nearest by the slope is at the place, up to rounding: 1 + exp(x) is small beside its
  // largest value, but its zero is far.
  const double rounding = 1e-13 * (axis.upper - axis.lower);
  const auto is_zero = [&](std::size_t i) {
    const double v = std::abs(values[i]);
    return v == 0 || (v <= 1e-14 * largest && v <= rounding * std::abs(part.slope(places[i])));
  };
  if (std::ranges::all_of(values, [](double v) { return v == 0; })) return;
  const auto is_below = [&](double x) { return part.value(x) < 0; };
  const auto is_nothing = [&](double x) { return part.value(x) == 0; };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == places.size();
    // Where a part is 0 all over a range, as max(0, x) is, the ends of that range count.
    const bool is_before_range = i + 1 < places.size() && values[i] == 0 && values[i + 1] == 0;
    const bool is_after_range = i > 0 && values[i] == 0 && values[i - 1] == 0;
    if (is_before_range || is_after_range) {
      if (!is_after_range && i > 0)
        edges.push_back({bisected(places[i - 1], places[i], is_nothing), power, hinge.is_jump});
      if (!is_before_range && !is_end)
        edges.push_back({bisected(places[i], places[i + 1], is_nothing), power, hinge.is_jump});
      continue;
    }
    if (is_zero(i) && (hinge.is_root || hinge.is_jump || !is_end))
      edges.push_back({places[i], power, hinge.is_jump});
    if (i == 0 || is_zero(i) || is_zero(i - 1)) continue;
    if ((values[i - 1] < 0) != (values[i] < 0)) {
      edges.push_back({bisected(places[i - 1], places[i], is_below), power, hinge.is_jump});
    } else if (part.slope(places[i - 1]) * values[i - 1] < 0 && part.slope(places[i]) * values[i] > 0) {
      // an extremum between, which may touch zero
      const double x =
          bisected(places[i - 1], places[i], [&](double at) { return part.slope(at) * values[i - 1] < 0; });
      if (std::abs(part.value(x)) <= 1e-12 * largest && part.range(x, x).may_be_zero)
        edges.push_back({x, power});
    }
  }
}

/// The same of a hinge of one variable.
void append_zeros(const Hinge& hinge, const StudyAxis& axis, std::vector<StudyEdge>& edges) {
  HingeCurve part(hinge.part, std::span(&axis, 1));
  append_zeros(hinge, part, axis, edges);
}

/// The same, of a hinge that others ask for too.
void append_known_zeros(const Hinge& hinge, const StudyAxis& axis, std::vector<StudyEdge>& edges) {
  const auto find = [&] {
    std::vector<StudyEdge> zeros;
    append_zeros(hinge, axis, zeros);
    return zeros;
  };
  const KnownZeros::Of of{to_text(hinge.part), hinge.is_root, hinge.is_jump, axis.lower, axis.upper};
  const std::vector<StudyEdge> zeros = axis.known_zeros ? axis.known_zeros->of(of, find) : find();
  edges.insert(edges.end(), zeros.begin(), zeros.end());
}

/// Sorts edges and merges those that differ by rounding. The ends stay where they are.
std::vector<StudyEdge> merged(const StudyAxis& axis, std::vector<StudyEdge> edges) {
  std::ranges::sort(edges, {}, &StudyEdge::at);
  std::vector<StudyEdge> result;
  const double near = 1e-13 * (axis.upper - axis.lower);
  for (const StudyEdge& edge : edges) {
    if (!result.empty() && edge.at - result.back().at <= near) {
      result.back().power = std::max(result.back().power, edge.power);
      result.back().is_jump = result.back().is_jump || edge.is_jump;
    } else {
      result.push_back(edge);
    }
  }
  result.front().at = axis.lower;
  result.back().at = axis.upper;
  if (result.size() > most_study_edges)
    throw UserError("--over '" + axis.variable +
                    "': more than 64 kinks, roots and poles: no more are allowed");
  return result;
}

/// The edges and the cuts between them. A cut next to 0 is far from 0 for a lobe there.
std::vector<StudyEdge> with_cuts(const StudyAxis& axis, std::vector<StudyEdge> edges) {
  for (const double cut : axis.cuts) {
    const auto next = std::ranges::lower_bound(edges, cut, {}, &StudyEdge::at);
    const double near = 1e-13 * std::abs(cut);
    if (next->at - cut > near && cut - std::prev(next)->at > near) edges.insert(next, {cut});
  }
  return edges;
}

/// The hinges of formulas whose variables pass, each once.
template <class Passes>
std::vector<Hinge> hinges_where(std::initializer_list<const Symbolic*> formulas, const Passes& passes) {
  std::vector<Hinge> result;
  std::set<std::tuple<std::string, bool, bool, bool>> known;
  for (const Symbolic* formula : formulas) {
    for (const Hinge& hinge : hinges_of(*formula)) {
      if (passes(free_variables(hinge.part)) &&
          known.emplace(to_text(hinge.part), hinge.is_root, hinge.is_pole, hinge.is_jump).second)
        result.push_back(hinge);
    }
  }
  return result;
}

/// A formula with a number in place of a variable.
Symbolic with_value(const Symbolic& formula, const std::string& variable, double value) {
  return evaluate<Symbolic>(formula, [&](const std::string& name) {
    return name == variable ? Symbolic::number(to_text(value)) : Symbolic::variable(name);
  });
}

/// The hinges of an axis and of later ones, with the later variables at their ends. Where the zeros of a
/// hinge reach such an end, the integral over the later variables is not smooth: that of sqrt(x y) over y at
/// x = 0, and that of |x^2 + y^2 - 1/2| at x = sqrt(1/2). A kink that reaches a corner of two variables
/// leaves it smooth.
std::vector<Hinge> hinges_at_later_ends(const ReadStudy& study, std::size_t index) {
  if (index + 1 == study.axes.size()) return {};
  const auto is_of_axis = [&](const std::set<std::string>& names) {
    return names.contains(study.axes[index].variable);
  };
  std::vector<Hinge> result;
  std::set<std::string> known;
  for (const Hinge& hinge : hinges_where({&study.target, &study.form, &study.weight}, is_of_axis)) {
    const std::set<std::string> names = free_variables(hinge.part);
    std::vector<Symbolic> parts{hinge.part};
    for (std::size_t later = index + 1; later < study.axes.size(); ++later) {
      const StudyAxis& axis = study.axes[later];
      if (!names.contains(axis.variable)) continue;
      std::vector<Symbolic> at_ends;
      for (const Symbolic& part : parts) {
        at_ends.push_back(with_value(part, axis.variable, axis.lower));
        at_ends.push_back(with_value(part, axis.variable, axis.upper));
      }
      parts = std::move(at_ends);
    }
    if (parts.size() == 1) continue;
    const bool counts_at_corner = hinge.is_root || parts.size() > 2;
    for (const Symbolic& part : parts)
      if (known.insert(to_text(part)).second) result.push_back({part, counts_at_corner, hinge.is_pole});
  }
  return result;
}

/// A hinge that depends on an axis and on axes before it, but on none after it.
struct MixedHinge {
  Hinge hinge;
  HingeCurve part;
};

std::vector<MixedHinge> mixed_hinges(const ReadStudy& study, std::size_t index) {
  if (index == 0) return {};
  const auto axes = std::span(study.axes).first(index + 1);
  std::set<std::string> known;
  for (const StudyAxis& axis : axes) known.insert(axis.variable);
  const auto is_mixed = [&](const std::set<std::string>& names) {
    return names.size() > 1 && names.contains(axes.back().variable) &&
           std::includes(known.begin(), known.end(), names.begin(), names.end());
  };
  std::vector<MixedHinge> result;
  for (const Hinge& hinge : hinges_where({&study.target, &study.form, &study.weight}, is_mixed))
    result.push_back({hinge, HingeCurve(hinge.part, axes)});
  for (Hinge hinge : hinges_at_later_ends(study, index)) {
    if (!is_mixed(free_variables(hinge.part))) continue;
    hinge.is_root = true;
    HingeCurve curve(hinge.part, axes);
    result.push_back({std::move(hinge), std::move(curve)});
  }
  return result;
}

/// The edges of an axis where the variables before it have given values.
std::vector<StudyEdge> edges_at(const StudyAxis& axis, std::vector<StudyEdge> edges,
                                std::vector<MixedHinge>& mixed, std::span<const long double> before) {
  for (auto& [hinge, part] : mixed) {
    part.set_before(before);
    append_zeros(hinge, part, axis, edges);
  }
  return merged(axis, std::move(edges));
}

/// The edges of an axis, and its ends where a root is zero in a corner, the axes before it at an end: near
/// that corner it is nearly singular there.
std::vector<StudyEdge> with_corners(const ReadStudy& study, std::vector<StudyEdge> edges,
                                    std::vector<MixedHinge>& mixed, std::size_t index) {
  const StudyAxis& axis = study.axes[index];
  for (std::size_t corner = 0; corner < std::size_t{1} << index; ++corner) {
    std::vector<long double> before;
    for (std::size_t k = 0; k < index; ++k)
      before.push_back((corner >> k & 1) != 0 ? study.axes[k].upper : study.axes[k].lower);
    for (auto& [hinge, part] : mixed) {
      part.set_before(before);
      for (const double end : {axis.lower, axis.upper})
        if (hinge.is_root && part.value(end) == 0) edges.push_back({end, power_at_root});
    }
  }
  return edges;
}

StudyNodes nodes_of_rows(const std::shared_ptr<const MeasuredRows>& rows) {
  StudyNodes nodes;
  if (rows->value.size() > most_copied_rows) {
    nodes.rows = rows;
    return nodes;
  }
  for (const auto* column : columns_of(*rows)) nodes.coordinates.emplace_back(column->begin(), column->end());
  nodes.weights.assign(rows->value.size(), 1.0L / static_cast<long double>(rows->value.size()));
  return nodes;
}

}  // namespace

std::vector<Symbolic> moving_kinks(const ReadStudy& study) {
  const auto has_parameter = [&](const std::set<std::string>& names) {
    return std::ranges::any_of(study.parameters, [&](const auto& name) { return names.contains(name); });
  };
  std::vector<Symbolic> kinks;
  for (const Hinge& hinge : hinges_where({&study.form}, has_parameter))
    if (!hinge.is_root && !hinge.is_pole) kinks.push_back(hinge.part);
  return kinks;
}

std::vector<StudyEdge> KnownZeros::of(const Of& hinge, const std::function<std::vector<StudyEdge>()>& find) {
  {
    const std::lock_guard guard(lock_);
    if (const auto known = found_.find(hinge); known != found_.end()) return known->second;
  }
  const std::vector<StudyEdge> zeros = find();
  const std::lock_guard guard(lock_);
  return found_.emplace(hinge, zeros).first->second;
}

std::vector<Symbolic> moving_poles(const ReadStudy& study) {
  std::vector<Symbolic> poles;
  for (const Hinge& hinge : hinges_of(study.form))
    if (hinge.is_pole && contains_any(hinge.part, study.parameters)) poles.push_back(hinge.part);
  return poles;
}

std::vector<StudyEdge> with_zeros(const StudyAxis& axis, std::vector<StudyEdge> edges,
                                  const std::vector<Symbolic>& formulas) {
  for (const Symbolic& formula : formulas)
    append_zeros({.part = formula, .is_root = false, .is_pole = false}, axis, edges);
  return merged(axis, std::move(edges));
}

Symbolic at_parameters(const ReadStudy& study, const Symbolic& formula,
                       const std::vector<double>& parameters) {
  return evaluate<Symbolic>(formula, [&](const std::string& name) {
    const auto found = std::find(study.parameters.begin(), study.parameters.end(), name);
    const auto i = static_cast<std::size_t>(found - study.parameters.begin());
    return i < parameters.size() ? Symbolic::number(to_text(parameters[i])) : Symbolic::variable(name);
  });
}

std::vector<double> zeros_of(const Symbolic& formula, const StudyAxis& axis) {
  std::vector<StudyEdge> edges;
  append_zeros({.part = formula, .is_root = true, .is_pole = false}, axis, edges);
  std::vector<double> zeros;
  for (const StudyEdge& edge : edges) zeros.push_back(edge.at);
  return zeros;
}

std::vector<StudyEdge> edges_of(const ReadStudy& study, std::size_t index) {
  const StudyAxis& axis = study.axes[index];
  std::vector<StudyEdge> edges{{axis.lower}, {axis.upper}};
  const auto is_of_axis = [&](const std::set<std::string>& names) {
    return names.size() == 1 && names.contains(axis.variable);
  };
  for (const Hinge& hinge :
       hinges_where({&study.target, &study.form, &study.weight, &axis.density}, is_of_axis))
    append_known_zeros(hinge, axis, edges);
  for (const Hinge& hinge : hinges_at_later_ends(study, index)) {
    if (!is_of_axis(free_variables(hinge.part))) continue;
    std::vector<StudyEdge> found;
    append_zeros({hinge.part, true, hinge.is_pole}, axis, found);
    for (const StudyEdge& edge : found) {
      const bool is_end = edge.at == axis.lower || edge.at == axis.upper;
      if (hinge.is_root || !is_end) edges.push_back(edge);
    }
  }
  // A relative error is 0/0 at a zero of the target. As an end of panels it has a limit from either side.
  if (study.error == Error::relative && is_of_axis(free_variables(study.target)))
    append_known_zeros({.part = study.target, .is_root = false, .is_pole = false}, axis, edges);
  return with_cuts(axis, merged(axis, std::move(edges)));
}

std::vector<StudyEdge> with_sides(const std::vector<StudyEdge>& edges) {
  const double lower = edges.front().at, upper = edges.back().at;
  // A bisection ends within a few roundings of the jump.
  const double beside = 1e-15 * std::max(std::abs(lower), std::abs(upper));
  std::vector<StudyEdge> result;
  for (const StudyEdge& edge : edges) {
    result.push_back(edge);
    if (!edge.is_jump) continue;
    result.back().at = std::max(lower, edge.at - beside);
    result.push_back({std::min(upper, edge.at + beside), edge.power});
  }
  return result;
}

std::vector<std::vector<StudyEdge>> edges_of(const ReadStudy& study) {
  std::vector<std::vector<StudyEdge>> edges;
  for (std::size_t i = 0; i < study.axes.size() && !study.rows; ++i) edges.push_back(edges_of(study, i));
  return edges;
}

bool is_one(const Symbolic& formula) {
  return formula.parts().empty() && formula.name() == "1";
}

std::vector<double> values_at_nodes(const ReadStudy& study, const Symbolic& formula,
                                    const StudyNodes& nodes) {
  TapeProgram<double> program(tape_of(formula, node_variables(study)), {});
  std::vector<const std::vector<double>*> columns;
  if (nodes.rows) columns = columns_of(*nodes.rows);
  std::vector<double> values, place(nodes.rows ? columns.size() : nodes.coordinates.size());
  values.reserve(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t i = 0; i < place.size(); ++i)
      place[i] = nodes.rows ? (*columns[i])[n] : static_cast<double>(nodes.coordinates[i][n]);
    program.run(place);
    values.push_back(program.output(0));
  }
  return values;
}

StudyNodes nodes_of(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                    unsigned rule_size) {
  if (study.rows) return nodes_of_rows(study.rows);
  StudyNodes nodes{{}, {1.0L}, 1};
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    std::vector<MixedHinge> mixed = mixed_hinges(study, i);
    const std::vector<StudyEdge> own = with_corners(study, edges[i], mixed, i);
    std::vector<AxisNode> of_axis = axis_nodes(study.axes[i], edges[i], rule_size);
    StudyNodes product{std::vector<std::vector<long double>>(i + 1), {}, 1};
    product.weights.reserve(nodes.weights.size() * of_axis.size());
    for (auto& coordinate : product.coordinates) coordinate.reserve(product.weights.capacity());
    for (std::size_t n = 0; n < nodes.weights.size(); ++n) {
      std::vector<long double> before;
      for (std::size_t k = 0; k < i; ++k) before.push_back(nodes.coordinates[k][n]);
      if (!mixed.empty())
        of_axis = axis_nodes(study.axes[i], edges_at(study.axes[i], own, mixed, before), rule_size);
      for (const AxisNode& node : of_axis) {
        for (std::size_t k = 0; k < i; ++k) product.coordinates[k].push_back(before[k]);
        product.coordinates[i].push_back(node.at);
        product.weights.push_back(nodes.weights[n] * node.weight);
      }
    }
    nodes = std::move(product);
  }
  nodes.total = 0;
  for (const long double weight : nodes.weights) nodes.total += weight;
  for (long double& weight : nodes.weights) weight /= nodes.total;
  return nodes;
}

}  // namespace shadefit
