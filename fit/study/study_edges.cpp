#include "fit/study/study_edges.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <set>
#include <utility>

#include "fit/scalars/hinges.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// A formula of shading has fewer edges. Each adds a panel.
constexpr std::size_t most_study_edges = 64;

/// Appends the zeros of a hinge of one variable as edges.
void append_zeros(const Hinge& hinge, const StudyAxis& axis, std::vector<StudyEdge>& edges) {
  HingeCurve(hinge, std::span(&axis.variable, 1)).append_zeros(axis.lower, axis.upper, edges);
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

std::vector<HingeCurve> mixed_hinges(const ReadStudy& study, std::size_t index) {
  if (index == 0) return {};
  const auto axes = std::span(study.axes).first(index + 1);
  std::vector<std::string> last_first{axes.back().variable};
  for (const StudyAxis& axis : axes.first(index)) last_first.push_back(axis.variable);
  const std::set<std::string> known(last_first.begin(), last_first.end());
  const auto is_mixed = [&](const std::set<std::string>& names) {
    return names.size() > 1 && names.contains(axes.back().variable) &&
           std::includes(known.begin(), known.end(), names.begin(), names.end());
  };
  std::vector<HingeCurve> result;
  for (const Hinge& hinge : hinges_where({&study.target, &study.form, &study.weight}, is_mixed))
    result.emplace_back(hinge, last_first);
  for (Hinge hinge : hinges_at_later_ends(study, index)) {
    if (!is_mixed(free_variables(hinge.part))) continue;
    hinge.is_root = true;
    result.emplace_back(std::move(hinge), last_first);
  }
  return result;
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

MovingEdges::MovingEdges(const ReadStudy& study, std::size_t axis, std::vector<StudyEdge> edges)
    : axis_(study.axes[axis]), edges_(std::move(edges)), mixed_(mixed_hinges(study, axis)) {
  // Near a corner where a root is zero, the axes before this one at an end, the formula is nearly singular.
  for (std::size_t corner = 0; corner < std::size_t{1} << axis; ++corner) {
    std::vector<long double> before;
    for (std::size_t k = 0; k < axis; ++k)
      before.push_back((corner >> k & 1) != 0 ? study.axes[k].upper : study.axes[k].lower);
    for (HingeCurve& hinge : mixed_) {
      hinge.set_others(before);
      for (const double end : {axis_.lower, axis_.upper})
        if (hinge.is_root_at(end)) edges_.push_back({end, power_at_root});
    }
  }
}

std::vector<StudyEdge> MovingEdges::at(std::span<const long double> before) {
  std::vector<StudyEdge> edges = edges_;
  for (HingeCurve& hinge : mixed_) {
    hinge.set_others(before);
    hinge.append_zeros(axis_.lower, axis_.upper, edges);
  }
  return merged(axis_, std::move(edges));
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

}  // namespace shadefit
