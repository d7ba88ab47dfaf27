#include "fit/study/largest_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "fit/study/study_problem.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

/// Places on one axis: between neighbouring edges the extrema of a Chebyshev polynomial, which are dense at
/// both edges. With `has_ends` they go on towards each edge in powers of two: a root or a logarithm there may
/// have a top closer to the edge than the first extremum.
std::vector<double> axis_places(const std::vector<StudyEdge>& edges, int count, bool has_ends) {
  std::vector<double> places{edges.front().at};
  const double first_sine = std::sin(std::numbers::pi / 2 / count);
  constexpr int halvings = 40, step = 2;
  places.reserve(edges.size() * static_cast<std::size_t>(count + halvings));
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const double lower = edges[i - 1].at, upper = edges[i].at, length = upper - lower;
    const double first = length * first_sine * first_sine;
    for (int k = halvings; has_ends && k > 0; k -= step) places.push_back(lower + std::ldexp(first, -k));
    for (int k = 1; k < count; ++k) {
      const double sine = std::sin(std::numbers::pi / 2 * k / count);
      places.push_back(lower + length * (sine * sine));
    }
    for (int k = step; has_ends && k <= halvings; k += step) places.push_back(upper - std::ldexp(first, -k));
    places.push_back(upper);
  }
  // Near an edge that is not 0 several places may round to one double.
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// |form - target| at a place.
class Magnitude {
 public:
  Magnitude(const ReadStudy& study, const std::vector<double>& parameters)
      : difference_(tape_of(study.form - study.target, formula_inputs(study)), parameters) {}

  double operator()(const std::vector<double>& at) {
    difference_.run(at);
    const double value = std::abs(difference_.output(0));
    // The form or the target may have no value: x log(x) is NaN at 0. Such a place does not count.
    return std::isnan(value) ? 0 : value;
  }

 private:
  TapeProgram<double> difference_;
};

/// Moves a place to the top of its hill, one variable after the other, by golden-section search between its
/// neighbours on the grid.
StudyExtremum refined(Magnitude& magnitude, StudyExtremum best,
                      const std::vector<std::array<double, 2>>& around) {
  constexpr double golden = 0.6180339887498949;
  // A ridge across the axes takes many passes.
  constexpr int most_passes = 40;
  for (int pass = 0; pass < (around.size() == 1 ? 1 : most_passes); ++pass) {
    const double before = best.magnitude;
    for (std::size_t axis = 0; axis < around.size(); ++axis) {
      auto [low, high] = around[axis];
      std::vector<double> at = best.at;
      const auto value = [&](double x) {
        at[axis] = x;
        return magnitude(at);
      };
      double left = high - golden * (high - low), right = low + golden * (high - low);
      double at_left = value(left), at_right = value(right);
      for (int i = 0; i < 60; ++i) {
        if (at_left < at_right) {
          low = left;
          left = right;
          at_left = at_right;
          at_right = value(right = low + golden * (high - low));
        } else {
          high = right;
          right = left;
          at_right = at_left;
          at_left = value(left = high - golden * (high - low));
        }
      }
      const double top = low + (high - low) / 2;
      // A smaller gain is rounding: then the place of the grid, perhaps an end, is the better answer.
      constexpr double gain = 1e-12;
      if (const double found = value(top); found > best.magnitude * (1 + gain)) {
        best.magnitude = found;
        best.at[axis] = top;
      }
    }
    if (best.magnitude == before) break;
  }
  return best;
}

/// |form - target| on the product of the places of each axis, the first one running fastest.
class Grid {
 public:
  Grid(Magnitude& magnitude, std::vector<std::vector<double>> places) : places_(std::move(places)) {
    std::size_t size = 1;
    for (const auto& axis : places_) size *= axis.size();
    values_.reserve(size);
    std::vector<double> at;
    for (std::size_t i = 0; i < size; ++i) {
      set_place(i, at);
      values_.push_back(magnitude(at));
      if (values_[i] > values_[largest_]) largest_ = i;
    }
  }

  std::vector<double> place(std::size_t index) const {
    std::vector<double> at;
    set_place(index, at);
    return at;
  }

  /// The place of the largest value, and all tops of at least `share` of it. A top is above its neighbours on
  /// each axis.
  std::vector<std::size_t> tops(double share) const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (i == largest_ || (values_[i] >= share * values_[largest_] && is_top(i))) result.push_back(i);
    }
    return result;
  }

  double value(std::size_t index) const { return values_[index]; }

  /// The neighbours on each axis; at an end of the axis the end is one of them.
  std::vector<std::array<double, 2>> around(std::size_t index) const {
    std::vector<std::array<double, 2>> result;
    for (const auto& axis : places_) {
      const std::size_t k = index % axis.size();
      result.push_back({axis[k == 0 ? 0 : k - 1], axis[std::min(k + 1, axis.size() - 1)]});
      index /= axis.size();
    }
    return result;
  }

 private:
  void set_place(std::size_t index, std::vector<double>& at) const {
    at.clear();
    for (const auto& axis : places_) {
      at.push_back(axis[index % axis.size()]);
      index /= axis.size();
    }
  }

  bool is_top(std::size_t index) const {
    std::size_t stride = 1;
    for (const auto& axis : places_) {
      const std::size_t k = index / stride % axis.size();
      if (k > 0 && values_[index - stride] >= values_[index]) return false;
      if (k + 1 < axis.size() && values_[index + stride] > values_[index]) return false;
      stride *= axis.size();
    }
    return true;
  }

  std::vector<std::vector<double>> places_;
  std::vector<double> values_;
  std::size_t largest_ = 0;
};

}  // namespace

std::vector<StudyExtremum> tops_of_error(const ReadStudy& study,
                                         const std::vector<std::vector<StudyEdge>>& edges,
                                         const std::vector<double>& parameters, double share) {
  constexpr std::array counts{200, 32, 12};
  // The share of a hill's height that the grid sees at least: near its top the error is a parabola.
  constexpr std::array shares{0.99, 0.95, 0.8};
  const std::size_t axes = study.axes.size();
  std::vector<std::vector<double>> places;
  for (const auto& of_axis : edges) places.push_back(axis_places(of_axis, counts[axes - 1], axes == 1));
  Magnitude magnitude(study, parameters);
  const Grid grid(magnitude, std::move(places));
  std::vector<StudyExtremum> tops;
  for (const std::size_t top : grid.tops(std::min(share, shares[axes - 1])))
    tops.push_back(refined(magnitude, {grid.value(top), grid.place(top)}, grid.around(top)));
  return tops;
}

StudyExtremum largest_error(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                            const std::vector<double>& parameters) {
  // Of equal tops, as in a minimax fit, the first one counts: which one is largest is rounding.
  constexpr double equal = 1e-9;
  StudyExtremum best;
  for (const StudyExtremum& top : tops_of_error(study, edges, parameters, 1)) {
    if (best.at.empty() || top.magnitude > best.magnitude * (1 + equal)) best = top;
  }
  return best;
}

StudyExtremum largest_error(const ReadStudy& study, const std::vector<double>& parameters) {
  if (study.rows) return largest_residual(study, parameters);
  std::vector<std::vector<StudyEdge>> edges;
  for (std::size_t i = 0; i < study.axes.size(); ++i) edges.push_back(edges_of(study, i));
  return largest_error(study, edges, parameters);
}

ReadStudy weighted_error_of(const ReadStudy& study) {
  ReadStudy weighted = study;
  weighted.form = error_formula(study);
  weighted.target = Symbolic::number("0");
  return weighted;
}

StudyExtremum largest_weighted_error(const ReadStudy& study, const std::vector<double>& parameters) {
  return largest_error(weighted_error_of(study), parameters);
}

StudyExtremum largest_residual(const ReadStudy& study, const std::vector<double>& parameters) {
  ReadStudy plain = study;
  plain.weight = Symbolic::number("1");
  plain.error = Error::absolute;
  const StudyError error(plain);
  VectorOf<double> errors;
  SampledStudy<double>(error, nodes_of(plain, {}, 1)).errors(parameters, errors, nullptr);
  StudyExtremum largest{errors.cwiseAbs().maxCoeff(), {}};
  // Of equal rows, as in a minimax fit, the first one counts: which one is largest is rounding.
  constexpr double equal = 1e-9;
  Eigen::Index row = 0;
  while (std::abs(errors[row]) < largest.magnitude * (1 - equal)) ++row;
  for (const auto& places : study.rows->places) largest.at.push_back(places[static_cast<std::size_t>(row)]);
  largest.row = static_cast<std::size_t>(row) + 1;
  return largest;
}

}  // namespace shadefit
