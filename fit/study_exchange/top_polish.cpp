#include "fit/study_exchange/top_polish.hpp"

#include <algorithm>
#include <cmath>

#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

/// A top closer to an edge than this share of the range moves to the edge if the error is not smaller there.
constexpr double at_edge = 1e-5;

Tape tape_of(const ReadStudy& weighted) {
  Graph graph(formula_inputs(weighted));
  std::vector<int> outputs{graph.add(weighted.form)};
  for (std::size_t i = 0; i < weighted.axes.size(); ++i)
    outputs.push_back(graph.derivative(outputs.front(), i));
  for (std::size_t i = 0; i < weighted.axes.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) outputs.push_back(graph.derivative(outputs[1 + i], j));
  }
  return {graph, outputs};
}

}  // namespace

TopPolish::TopPolish(const ReadStudy& weighted, const std::vector<std::vector<StudyEdge>>& edges)
    : axes_(weighted.axes), edges_(edges), tape_(tape_of(weighted)) {}

std::vector<double> TopPolish::operator()(std::vector<double> place,
                                          const std::vector<double>& parameters) const {
  std::vector<bool> is_free(axes_.size(), true);
  for (std::size_t i = 0; i < axes_.size(); ++i) is_free[i] = !snap(place, i, parameters);
  const double before = std::abs(at(place, parameters).front());
  std::vector<double> moved = place;
  for (int pass = 0; pass < 4; ++pass) {
    if (!step(moved, is_free, parameters)) return place;
  }
  return std::abs(at(moved, parameters).front()) >= before * (1 - 1e-9) ? moved : place;
}

std::vector<double> TopPolish::at(const std::vector<double>& place,
                                  const std::vector<double>& parameters) const {
  std::vector<double> inputs = place;
  inputs.insert(inputs.end(), parameters.begin(), parameters.end());
  return tape_(std::span<const double>(inputs));
}

bool TopPolish::snap(std::vector<double>& place, std::size_t axis,
                     const std::vector<double>& parameters) const {
  for (const StudyEdge& edge : edges_[axis]) {
    if (std::abs(place[axis] - edge.at) > at_edge * (axes_[axis].upper - axes_[axis].lower)) continue;
    std::vector<double> snapped = place;
    snapped[axis] = edge.at;
    if (std::abs(at(snapped, parameters).front()) < std::abs(at(place, parameters).front()) * (1 - 1e-9))
      continue;
    place = snapped;
    return true;
  }
  return false;
}

/// One Newton step along the free variables. False if it is too long.
bool TopPolish::step(std::vector<double>& place, const std::vector<bool>& is_free,
                     const std::vector<double>& parameters) const {
  const auto n = static_cast<Eigen::Index>(axes_.size());
  const std::vector<double> values = at(place, parameters);
  VectorOf<double> slope = VectorOf<double>::Zero(n);
  MatrixOf<double> curvature = MatrixOf<double>::Identity(n, n);
  std::size_t next = axes_.size() + 1;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto first = static_cast<std::size_t>(i);
    if (is_free[first]) slope[i] = values[1 + first];
    for (Eigen::Index j = 0; j <= i; ++j, ++next) {
      if (is_free[first] && is_free[static_cast<std::size_t>(j)])
        curvature(i, j) = curvature(j, i) = values[next];
    }
  }
  const VectorOf<double> move = -solution(pivoted_qr(curvature), slope);
  for (Eigen::Index i = 0; i < n; ++i) {
    const StudyAxis& axis = axes_[static_cast<std::size_t>(i)];
    double& x = place[static_cast<std::size_t>(i)];
    if (!(std::abs(move[i]) <= 1e-3 * (axis.upper - axis.lower))) return false;
    x = std::clamp(x + move[i], axis.lower, axis.upper);
  }
  return true;
}

std::vector<std::vector<double>> polished_tops(const ReadStudy& weighted,
                                               const std::vector<std::vector<StudyEdge>>& edges,
                                               const TopPolish& polish,
                                               const std::vector<double>& parameters) {
  std::vector<std::vector<double>> places;
  for (const StudyExtremum& top : tops_of_error(weighted, edges, parameters, 0.3))
    places.push_back(polish(top.at, parameters));
  return places;
}

}  // namespace shadefit
