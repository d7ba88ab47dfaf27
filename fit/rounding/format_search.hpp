#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/rounding/lattice_search.hpp"
#include "fit/support/checkpoint.hpp"

/// The search of a number format for the best constants.
namespace shadefit {

/// If the whole lattice is too large to search: steps to each side of the best point so far.
inline constexpr std::int64_t neighbourhood = 16;
/// The most parameters for which the whole lattice can be searched.
inline constexpr std::size_t most_dimensions = 2;
/// The most neighbourhoods of a search.
inline constexpr int most_moves = 100;

/// Marks the given parameters; they keep their value from the first start.
template <std::size_t N>
using GivenPlaces = std::array<bool, N>;

template <std::size_t N>
struct FormatOptimum {
  LatticePoint<N> point{};
  bool is_proven = false;  ///< no other constants among those searched are better
  std::string searched;    ///< the set of constants that was searched, in words
  long boxes = 0;          ///< number of bounded boxes
  long evaluated = 0;      ///< constants whose error was computed
};

/// Searches the whole lattice up to `last`, or else neighbourhoods until the best point is the centre of its
/// neighbourhood.
template <std::size_t N>
FormatOptimum<N> search_format(const LatticeProblem<N>& problem, std::int64_t last,
                               const std::vector<LatticePoint<N>>& starts, const GivenPlaces<N>& given,
                               const NumberFormat& format, long limit, const Checkpoint& checkpoint) {
  LatticeOptimum<N> best;
  if constexpr (N <= most_dimensions) {
    LatticeBox<N> all;
    all.lower.fill(-last);
    all.upper.fill(last);
    for (std::size_t i = 0; i < N; ++i) {
      if (given[i]) all.lower[i] = all.upper[i] = starts.front()[i];
    }
    best = search_lattice<N>(problem, all, starts, limit, checkpoint);
    const std::string searched = format.kind == NumberFormat::Kind::decimal
                                     ? "all numbers of the format from 1e-20 to 1e21 in magnitude, and 0"
                                     : "all finite numbers of the format";
    if (best.is_proven) return {best.point, true, searched, best.boxes, best.evaluated};
  }
  std::vector<LatticePoint<N>> from = starts;
  if (std::isfinite(best.error)) from.push_back(best.point);
  LatticePoint<N> centre = from.back();
  FormatOptimum<N> found{
      .searched = "the constants within " + std::to_string(neighbourhood) + " steps of the format",
      .boxes = best.boxes,
      .evaluated = best.evaluated};
  for (int move = 0; move < most_moves; ++move) {
    LatticeBox<N> box;
    for (std::size_t i = 0; i < N; ++i) {
      const std::int64_t steps = given[i] ? 0 : neighbourhood;
      box.lower[i] = std::max(-last, centre[i] - steps);
      box.upper[i] = std::min(last, centre[i] + steps);
    }
    best = search_lattice<N>(problem, box, from, limit, checkpoint);
    found.boxes += best.boxes;
    found.evaluated += best.evaluated;
    found.point = best.point;
    found.is_proven = best.is_proven && best.point == centre;
    if (best.point == centre || !best.is_proven) break;
    centre = best.point;
    from = {centre};
  }
  return found;
}

}  // namespace shadefit
