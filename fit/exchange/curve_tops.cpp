#include "fit/exchange/curve_tops.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/formula/graph.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

Tape tape_of_parts(const ReadStudy& study, const Symbolic& formula, bool is_slope, bool has_derivatives) {
  const std::vector<std::string> inputs = formula_inputs(study);
  const std::size_t variables = study.axes.size();
  Graph graph(inputs);
  const int node = graph.add(formula);
  std::vector<int> parts{is_slope ? graph.derivative(node, 0) : node}, outputs;
  for (std::size_t i = 0; i < variables; ++i) parts.push_back(graph.derivative(parts.front(), i));
  for (std::size_t i = 0; i < variables; ++i) {
    for (std::size_t j = 0; j <= i; ++j) parts.push_back(graph.derivative(parts[1 + i], j));
  }
  for (const int part : parts) {
    outputs.push_back(part);
    for (std::size_t i = variables; has_derivatives && i < inputs.size(); ++i)
      outputs.push_back(graph.derivative(part, i));
  }
  return {graph, outputs};
}

double width_of(const std::vector<StudyEdge>& edges) {
  return edges.back().at - edges.front().at;
}

std::size_t at(const std::vector<Eigen::Index>& axes, Eigen::Index i) {
  return static_cast<std::size_t>(axes[static_cast<std::size_t>(i)]);
}

/// The variables along which a curve may rise from a place: from an end of the range into it.
std::vector<Eigen::Index> rising_axes(const Place& place, const std::vector<CurvePart>& parts,
                                      const Edges& edges) {
  std::vector<Eigen::Index> axes = free_axes(place, edges);
  for (std::size_t i = 0; i < place.size(); ++i) {
    const long double slope = parts[1 + i].value;
    if ((place[i] == edges[i].front().at && slope > 0) || (place[i] == edges[i].back().at && slope < 0))
      axes.push_back(static_cast<Eigen::Index>(i));
  }
  std::ranges::sort(axes);
  return axes;
}

/// Newton's step to the top. Along a direction that bends upwards it goes the other way: the curve rises
/// there.
VectorOf<double> ascent(const std::vector<CurvePart>& parts, std::size_t variables,
                        const std::vector<Eigen::Index>& axes) {
  VectorOf<double> slope(static_cast<Eigen::Index>(axes.size()));
  for (Eigen::Index i = 0; i < slope.size(); ++i)
    slope[i] = static_cast<double>(parts[1 + at(axes, i)].value);
  const MatrixOf<double> bend = curvature_along(parts, variables, axes);
  if (slope.size() == 0 || !bend.allFinite()) return slope * HUGE_VAL;
  const auto found = eigen_of(bend);
  const VectorOf<double> along = found.eigenvectors().transpose() * slope;
  return found.eigenvectors() * along.cwiseQuotient(found.eigenvalues().cwiseAbs());
}

Place moved_by_step(Place place, const VectorOf<double>& step, const std::vector<Eigen::Index>& axes,
                    const Edges& edges) {
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    const auto& of_axis = edges[at(axes, i)];
    place[at(axes, i)] = std::clamp(place[at(axes, i)] + step[i], of_axis.front().at, of_axis.back().at);
  }
  return place;
}

}  // namespace

Wide wide(const std::vector<double>& parameters) {
  return Eigen::Map<const VectorOf<double>>(parameters.data(), std::ssize(parameters)).cast<long double>();
}

CurveParts::CurveParts(const ReadStudy& study, const Symbolic& formula, bool is_slope, bool has_derivatives)
    : variables_(study.axes.size()),
      derivatives_(has_derivatives ? study.parameters.size() : 0),
      parts_(tape_of_parts(study, formula, is_slope, has_derivatives), {}) {}

std::vector<CurvePart> CurveParts::at(const Place& place, const Wide& parameters) {
  std::vector<long double> inputs(place.begin(), place.end());
  inputs.insert(inputs.end(), parameters.begin(), parameters.end());
  parts_.run(inputs);
  std::vector<CurvePart> parts(1 + variables_ + variables_ * (variables_ + 1) / 2);
  std::size_t next = 0;
  for (CurvePart& part : parts) {
    part.value = parts_.output(next++);
    part.slope.resize(static_cast<Eigen::Index>(derivatives_));
    for (long double& slope : part.slope) slope = parts_.output(next++);
  }
  return parts;
}

bool are_near(const Place& a, const Place& b, const std::vector<StudyAxis>& axes, double share) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > share * (axes[i].upper - axes[i].lower)) return false;
  }
  return true;
}

std::vector<Eigen::Index> free_axes(const Place& place, const Edges& edges) {
  std::vector<Eigen::Index> axes;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const auto is_here = [&](const StudyEdge& edge) { return edge.at == place[i]; };
    if (std::none_of(edges[i].begin(), edges[i].end(), is_here)) axes.push_back(static_cast<Eigen::Index>(i));
  }
  return axes;
}

MatrixOf<double> curvature_along(const std::vector<CurvePart>& parts, std::size_t variables,
                                 const std::vector<Eigen::Index>& axes) {
  const auto size = static_cast<Eigen::Index>(axes.size());
  MatrixOf<double> result(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      const auto row = static_cast<std::size_t>(axes[static_cast<std::size_t>(i)]),
                 column = static_cast<std::size_t>(axes[static_cast<std::size_t>(j)]);
      result(i, j) = result(j, i) =
          static_cast<double>(parts[1 + variables + row * (row + 1) / 2 + column].value);
    }
  }
  return result;
}

Place top_near(CurveParts& curve, Place place, const Wide& parameters, const Edges& edges) {
  constexpr int most_passes = 40, most_halvings = 20;
  constexpr double at_edge = 1e-5;  // of the range: a top closer to an edge is at the edge if that is higher
  constexpr double most_step = 0.02;  // of the range: a longer one may leave the hill
  constexpr double nearby = 1e-5;     // of that
  const auto height = [&](const Place& at) { return curve.at(at, parameters).front().value; };
  long double reached = height(place);
  const auto climbs_to = [&](const Place& at) {
    const long double there = height(at);
    if (!(there >= reached) || !std::isfinite(there)) return false;
    reached = there;
    place = at;
    return true;
  };
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (const StudyEdge& edge : edges[i]) {
      Place snapped = place;
      snapped[i] = edge.at;
      if (std::abs(place[i] - edge.at) <= at_edge * width_of(edges[i])) climbs_to(snapped);
    }
  }
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<CurvePart> parts = curve.at(place, parameters);
    const std::vector<Eigen::Index> axes = rising_axes(place, parts, edges);
    VectorOf<double> step = ascent(parts, place.size(), axes);
    if (axes.empty() || !step.allFinite()) return place;
    double longest = 0;  // of the longest step that is allowed
    for (Eigen::Index i = 0; i < step.size(); ++i)
      longest = std::max(longest, std::abs(step[i]) / (most_step * width_of(edges[at(axes, i)])));
    if (longest > 1) step /= longest;
    // The height does not tell places this near, the slope does.
    bool has_climbed = longest < nearby;
    if (has_climbed) {
      const Place before = std::exchange(place, moved_by_step(place, step, axes, edges));
      if (!std::isfinite(height(place))) return before;
      if (longest < 1e-10 || place == before) return place;
    }
    for (int halving = 0; halving < most_halvings && !has_climbed; ++halving, step /= 2) {
      const Place moved = moved_by_step(place, step, axes, edges);
      if (moved == place) return place;
      has_climbed = climbs_to(moved);
    }
    if (!has_climbed) return place;
  }
  return place;
}

ErrorTops::ErrorTops(const ReadStudy& study, const Edges& edges)
    : weighted_(weighted_error_of(study)),
      edges_(edges),
      error_(weighted_, weighted_.form, false, false),
      negative_(weighted_, -weighted_.form, false, false) {}

Place ErrorTops::near(const Place& place, const std::vector<double>& parameters) {
  const bool is_positive = error_.at(place, wide(parameters)).front().value > 0;
  return top_near(is_positive ? error_ : negative_, place, wide(parameters), edges_);
}

std::vector<StudyExtremum> ErrorTops::all(const std::vector<double>& parameters) {
  std::vector<StudyExtremum> tops = tops_of_error(weighted_, edges_, parameters, 0.3);
  for (StudyExtremum& top : tops) {
    if (std::isfinite(top.magnitude)) top.at = near(top.at, parameters);
  }
  return tops;
}

}  // namespace shadefit
