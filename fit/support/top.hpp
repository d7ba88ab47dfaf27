#pragma once

#include <cmath>

/// Where a function of one number is largest.
namespace shadefit {

/// Values that differ by a smaller share are equal, up to rounding.
inline constexpr double rounding_of_values = 1e-12;

/// The vertex of the parabola through the values at a place and one step beside it, or the place if they show
/// no top between `low` and `high`. A step is a 500th of that range, so if the range is about a 200th of all,
/// a step is 1e-5 of it: there the rounding of the values, eps/step, moves the vertex as little as the cubic
/// term, step^2.
template <class Value>
double vertex_beside(const Value& value, double place, double low, double high) {
  constexpr double share = 2e-3;
  const double step = share * (high - low), middle = value(place), left = value(place - step),
               right = value(place + step), bend = left - 2 * middle + right;
  const double vertex = place + step / 2 * (left - right) / bend;
  const bool is_top = bend < 0 && std::abs(vertex - place) < step && low <= vertex && vertex <= high;
  return is_top && value(vertex) >= middle * (1 - rounding_of_values) ? vertex : place;
}

/// The top of the only hill between two places, by golden-section search.
template <class Value>
double top_between(const Value& value, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  const double first = low, last = high;
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
  return vertex_beside(value, low + (high - low) / 2, first, last);
}

}  // namespace shadefit
