#include "fit/study/largest_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "fit/formula/batch.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/top.hpp"

namespace shadefit {
namespace {

/// Places on one axis: between neighbouring edges the extrema of a Chebyshev polynomial, which are dense at
/// both edges. With `has_ends` they go on towards each edge in powers of two: a root or a logarithm there may
/// have a top closer to the edge than the first extremum.
std::vector<double> axis_places(const std::vector<StudyEdge>& edges, int count, bool has_ends) {
  std::vector<double> places{edges.front().at};
  // The shares of the length, sin^2: they are symmetric.
  std::vector<double> shares(static_cast<std::size_t>(count));
  for (int k = 1; 2 * k <= count; ++k) {
    const double sine = std::sin(std::numbers::pi / 2 * k / count);
    shares[static_cast<std::size_t>(count - k)] = 1 - sine * sine;
    shares[static_cast<std::size_t>(k)] = sine * sine;
  }
  constexpr int halvings = 40, step = 2;
  places.reserve(edges.size() * static_cast<std::size_t>(count + halvings));
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const double lower = edges[i - 1].at, upper = edges[i].at, length = upper - lower;
    const double first = length * shares[1];
    for (int k = halvings; has_ends && k > 0; k -= step) places.push_back(lower + std::ldexp(first, -k));
    for (int k = 1; k < count; ++k) places.push_back(lower + length * shares[static_cast<std::size_t>(k)]);
    for (int k = step; has_ends && k <= halvings; k += step) places.push_back(upper - std::ldexp(first, -k));
    places.push_back(upper);
  }
  // Near an edge that is not 0 several places may round to one double.
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// The height of a curve above 0, or of its finite values above a ground.
class Magnitude {
 public:
  Magnitude(const Tape& curve, std::optional<double> ground, const std::vector<double>& parameters)
      : ground_(ground), parameters_(parameters), curve_(curve, parameters) {}

  double operator()(const std::vector<double>& at) {
    curve_.run(at);
    return height(curve_.output(0));
  }

  /// At many places, up to rounding: for each variable its value at each of them.
  std::vector<double> over(std::span<const std::vector<double>> coordinates) const {
    std::vector<double> values = values_at(curve_.tape(), coordinates, parameters_);
    for (double& value : values) value = height(value);
    return values;
  }

 private:
  /// The form or the target may have no value: x log(x) is NaN at 0. Such a place does not count.
  double height(double value) const {
    if (ground_ && !std::isfinite(value)) return 0;
    return std::max(0.0, value - ground_.value_or(0));
  }

  std::optional<double> ground_;

  const std::vector<double>& parameters_;
  TapeProgram<double> curve_;
};

/// Moves a place to the top of its hill, one variable after the other, by golden-section search between its
/// neighbours on the grid.
StudyExtremum refined(Magnitude& magnitude, StudyExtremum best,
                      const std::vector<std::array<double, 2>>& around) {
  // A ridge across the axes takes many passes.
  constexpr int most_passes = 40;
  for (int pass = 0; pass < (around.size() == 1 ? 1 : most_passes); ++pass) {
    const double before = best.magnitude;
    for (std::size_t axis = 0; axis < around.size(); ++axis) {
      std::vector<double> at = best.at;
      const auto value = [&](double x) {
        at[axis] = x;
        return magnitude(at);
      };
      const double top = top_between(value, around[axis][0], around[axis][1]);
      // Without a gain the place of the grid, perhaps an end, is the better answer.
      if (const double found = value(top); found > best.magnitude * (1 + rounding_of_values)) {
        best.magnitude = found;
        best.at[axis] = top;
      }
    }
    if (best.magnitude == before) break;
  }
  return best;
}

/// The heights on the product of the places of each axis, the first one running fastest.
class Grid {
 public:
  Grid(const Magnitude& magnitude, std::vector<std::vector<double>> places) : places_(std::move(places)) {
    std::size_t size = 1, stride = 1;
    for (const auto& axis : places_) size *= axis.size();
    std::vector<std::vector<double>> coordinates;
    for (const auto& axis : places_) {
      std::vector<double>& of_variable = coordinates.emplace_back();
      of_variable.reserve(size);
      while (of_variable.size() < size) {
        for (const double x : axis) of_variable.insert(of_variable.end(), stride, x);
      }
      stride *= axis.size();
    }
    values_ = magnitude.over(coordinates);
    largest_ = static_cast<std::size_t>(std::max_element(values_.begin(), values_.end()) - values_.begin());
    // Of places that differ by rounding an end is the better answer.
    for (const std::size_t end : {size - 1, std::size_t{0}}) {
      if (values_[end] >= values_[largest_] * (1 - rounding_of_values)) largest_ = end;
    }
  }

  std::vector<double> place(std::size_t index) const {
    std::vector<double> at;
    for (const auto& axis : places_) {
      at.push_back(axis[index % axis.size()]);
      index /= axis.size();
    }
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
  const Symbolic magnitude = Symbolic::function("abs", {difference_of(study)});
  return tops_of(tape_of(magnitude, formula_inputs(study)), std::nullopt, edges, parameters, share);
}

std::vector<StudyExtremum> tops_of(const Tape& curve, std::optional<double> ground,
                                   const std::vector<std::vector<StudyEdge>>& edges,
                                   const std::vector<double>& parameters, double share) {
  constexpr std::array counts{200, 32, 12};
  // The share of a hill's height that the grid sees at least: near its top the error is a parabola.
  constexpr std::array shares{0.99, 0.95, 0.8};
  const std::size_t axes = edges.size();
  std::vector<std::vector<double>> places;
  for (const auto& of_axis : edges)
    places.push_back(axis_places(with_sides(of_axis), counts[axes - 1], axes == 1));
  Magnitude magnitude(curve, ground, parameters);
  const Grid grid(magnitude, std::move(places));
  std::vector<StudyExtremum> tops;
  for (const std::size_t top : grid.tops(std::min(share, shares[axes - 1]))) {
    const std::vector<double> place = grid.place(top);
    tops.push_back(refined(magnitude, {magnitude(place), place}, grid.around(top)));
  }
  return tops;
}

namespace {

/// Whether an error is mostly rounding: it is far below the target, and wider arithmetic has another one. At
/// a jump wider arithmetic may be on its other side.
bool is_rounding(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                 const std::vector<double>& parameters, const StudyExtremum& error) {
  const std::vector<long double> wide(parameters.begin(), parameters.end()),
      at(error.at.begin(), error.at.end());
  TapeProgram<long double> difference(tape_of(difference_of(study), formula_inputs(study)), wide);
  difference.run(at);
  if (!(std::abs(std::abs(difference.output(0)) - error.magnitude) > error.magnitude / 2)) return false;
  ReadStudy target = study;
  target.form = Symbolic::number("0");
  target.residual.reset();
  double largest = 0;
  for (const StudyExtremum& top : tops_of_error(target, edges, parameters, 1))
    largest = std::max(largest, top.magnitude);
  return error.magnitude < rounding_of_values * largest;
}

}  // namespace

StudyExtremum largest_error(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                            const std::vector<double>& parameters) {
  // Of equal tops, as in a minimax fit, the first one counts: which one is largest is rounding. So is a top
  // next to an end of one axis.
  constexpr double equal = 1e-9;
  const auto is_end_beside = [&](double at, double other) {
    const double lower = edges.front().front().at, upper = edges.front().back().at;
    return edges.size() == 1 && (at == lower || at == upper) &&
           std::abs(at - other) <= equal * (upper - lower);
  };
  StudyExtremum best;
  for (const StudyExtremum& top : tops_of_error(study, edges, parameters, 1)) {
    if (best.at.empty() || top.magnitude > best.magnitude * (1 + equal) ||
        (top.magnitude >= best.magnitude * (1 - rounding_of_values) &&
         is_end_beside(top.at.front(), best.at.front())))
      best = top;
  }
  if (!is_rounding(study, edges, parameters, best)) return best;
  StudyExtremum none;
  for (const auto& of_axis : edges) none.at.push_back(of_axis.front().at);
  return none;
}

std::optional<double> pole_of(const ReadStudy& study, const std::vector<double>& parameters) {
  if (study.rows || study.axes.size() > 1) return std::nullopt;
  for (const Symbolic& pole : moving_poles(study)) {
    const StudyAxis& axis = study.axes.front();
    for (const double place : zeros_of(at_parameters(study, pole, parameters), axis))
      if (axis.lower < place && place < axis.upper) return place;
  }
  return std::nullopt;
}

StudyExtremum largest_error(const ReadStudy& study, const std::vector<double>& parameters) {
  if (study.rows) return largest_residual(study, parameters);
  if (const auto pole = pole_of(study, parameters)) return {HUGE_VAL, {*pole}};
  return largest_error(study, edges_of(study), parameters);
}

ReadStudy weighted_error_of(const ReadStudy& study) {
  ReadStudy weighted = study;
  weighted.form = error_formula(study);
  weighted.target = Symbolic::number("0");
  weighted.residual.reset();
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
