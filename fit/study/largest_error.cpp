#include "fit/study/largest_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// Places of one axis: the extrema of a Chebyshev polynomial between neighbouring edges, which crowd at both.
std::vector<double> axis_places(const std::vector<StudyEdge>& edges, int count) {
  std::vector<double> places{edges.front().at};
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const double lower = edges[i - 1].at, length = edges[i].at - lower;
    for (int k = 1; k < count; ++k) {
      const double sine = std::sin(std::numbers::pi / 2 * k / count);
      places.push_back(lower + length * (sine * sine));
    }
    places.push_back(edges[i].at);
  }
  return places;
}

/// |form - target| at a place.
class Magnitude {
 public:
  Magnitude(const ReadStudy& study, const std::vector<double>& parameters)
      : study_(study), parameters_(parameters), difference_(study.form - study.target) {}

  double operator()(const std::vector<double>& at) const {
    const double value = std::abs(evaluate<double>(difference_, [&](const std::string& name) {
      for (std::size_t i = 0; i < study_.axes.size(); ++i) {
        if (study_.axes[i].variable == name) return at[i];
      }
      std::size_t i = 0;
      while (study_.parameters[i] != name) ++i;
      return parameters_[i];
    }));
    // Without a value at a place, such as x log(x) at 0. An infinite error is one.
    return std::isnan(value) ? 0 : value;
  }

 private:
  const ReadStudy& study_;
  const std::vector<double>& parameters_;
  Symbolic difference_;
};

/// A place moved to the top of its hill, one variable after the other, by golden sections between its
/// neighbours on the grid.
StudyExtremum refined(const Magnitude& magnitude, StudyExtremum best,
                      const std::vector<std::array<double, 2>>& around) {
  constexpr double golden = 0.6180339887498949;
  for (int pass = 0; pass < (around.size() == 1 ? 1 : 6); ++pass) {
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
      // Less is rounding: then the place of the grid, an end perhaps, is the better answer.
      constexpr double gain = 1e-12;
      if (const double found = value(top); found > best.magnitude * (1 + gain)) {
        best.magnitude = found;
        best.at[axis] = top;
      }
    }
  }
  return best;
}

}  // namespace

StudyExtremum largest_error(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                            const std::vector<double>& parameters) {
  constexpr std::array counts{200, 32, 12};
  const std::size_t axes = study.axes.size();
  std::vector<std::vector<double>> places;
  for (const auto& of_axis : edges) places.push_back(axis_places(of_axis, counts[axes - 1]));
  const Magnitude magnitude(study, parameters);

  // Every place of the product, the tops kept with the neighbours between which they lie.
  StudyExtremum best;
  std::vector<std::size_t> index(axes, 0), best_index = index;
  for (bool goes_on = true; goes_on;) {
    std::vector<double> at;
    for (std::size_t i = 0; i < axes; ++i) at.push_back(places[i][index[i]]);
    const double value = magnitude(at);
    if (best.at.empty() || value > best.magnitude) {
      best = {value, at};
      best_index = index;
    }
    goes_on = false;
    for (std::size_t i = 0; i < axes && !goes_on; ++i) {
      goes_on = ++index[i] < places[i].size();
      if (!goes_on) index[i] = 0;
    }
  }
  std::vector<std::array<double, 2>> around;
  for (std::size_t i = 0; i < axes; ++i) {
    const std::size_t k = best_index[i];
    around.push_back({places[i][k == 0 ? 0 : k - 1], places[i][std::min(k + 1, places[i].size() - 1)]});
  }
  return refined(magnitude, best, around);
}

StudyExtremum largest_error(const ReadStudy& study, const std::vector<double>& parameters) {
  if (study.rows) return largest_residual(study, parameters);
  std::vector<std::vector<StudyEdge>> edges;
  for (std::size_t i = 0; i < study.axes.size(); ++i) edges.push_back(edges_of(study, i));
  return largest_error(study, edges, parameters);
}

StudyExtremum largest_residual(const ReadStudy& study, const std::vector<double>& parameters) {
  ReadStudy plain = study;
  plain.weight = Symbolic::number("1");
  plain.error = Error::absolute;
  const StudyError error(plain);
  VectorOf<double> errors;
  SampledStudy<double>(error, nodes_of(plain, {}, 1)).errors(parameters, errors, nullptr);
  Eigen::Index row = 0;
  StudyExtremum largest{errors.cwiseAbs().maxCoeff(&row), {}};
  for (const auto& places : study.rows->places) largest.at.push_back(places[static_cast<std::size_t>(row)]);
  largest.row = static_cast<std::size_t>(row) + 1;
  return largest;
}

}  // namespace shadefit
