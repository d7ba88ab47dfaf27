#pragma once

#include <utility>
#include <vector>

#include "fit/study/study.hpp"

namespace shadefit {

/// The places of a grid over the ranges of a study, with so many even steps along each axis. The last place
/// of an axis is the upper end itself.
inline std::vector<std::vector<double>> even_grid(const std::vector<StudyAxis>& axes, int steps) {
  std::vector<std::vector<double>> places{{}};
  for (const StudyAxis& axis : axes) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& place : places) {
      for (int i = 0; i <= steps; ++i) {
        longer.push_back(place);
        longer.back().push_back(i == steps ? axis.upper : axis.lower + (axis.upper - axis.lower) * i / steps);
      }
    }
    places = std::move(longer);
  }
  return places;
}

}  // namespace shadefit
