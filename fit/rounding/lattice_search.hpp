#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/support/checkpoint.hpp"

/// The best point of a lattice, by branch and bound, and with it the best constants of a number format.
namespace shadefit {

template <std::size_t N>
using LatticePoint = std::array<std::int64_t, N>;

/// The points between two corners, both included.
template <std::size_t N>
struct LatticeBox {
  LatticePoint<N> lower;
  LatticePoint<N> upper;

  bool is_point() const { return lower == upper; }
  std::size_t widest() const {
    std::size_t widest = 0;
    for (std::size_t i = 1; i < N; ++i) {
      if (upper[i] - lower[i] > upper[widest] - lower[widest]) widest = i;
    }
    return widest;
  }
  LatticePoint<N> centre() const {
    LatticePoint<N> point;
    for (std::size_t i = 0; i < N; ++i) point[i] = lower[i] + (upper[i] - lower[i]) / 2;
    return point;
  }
};

template <std::size_t N>
struct LatticeOptimum {
  LatticePoint<N> point{};
  double error = std::numeric_limits<double>::infinity();
  long boxes = 0;          ///< number of bounded boxes
  long evaluated = 0;      ///< points whose error was computed
  bool is_proven = false;  ///< no other point of the box is better
};

/// A type-erased problem: the search is compiled only once for each number of coordinates.
template <std::size_t N>
struct LatticeProblem {
  /// A lower bound of the error of all points of the box. May return early with any value >= `best`.
  std::function<double(const LatticeBox<N>& box, double best)> bound;
  /// The error of a point, or any value >= `best` if the point is no better.
  std::function<double(const LatticePoint<N>& point, double best)> error;
};

/// Wraps a problem with members `bound` and `error`. The problem must outlive the result.
template <std::size_t N, class Problem>
LatticeProblem<N> lattice_problem(Problem& problem) {
  return {[&problem](const LatticeBox<N>& box, double best) { return problem.bound(box, best); },
          [&problem](const LatticePoint<N>& point, double best) { return problem.error(point, best); }};
}

/// Best first: the box with the lowest bound is cut at its widest side and its centre is evaluated, which
/// soon gives a good error for pruning. Of points with equal errors the first one stays. Gives up after
/// `limit` boxes; calls `checkpoint` now and then.
template <std::size_t N>
LatticeOptimum<N> search_lattice(const LatticeProblem<N>& problem, const LatticeBox<N>& all,
                                 const std::vector<LatticePoint<N>>& starts, long limit,
                                 const Checkpoint& checkpoint) {
  struct Open {
    double bound;
    long order;
    LatticeBox<N> box;
    bool operator<(const Open& other) const {
      return bound != other.bound ? bound > other.bound : order > other.order;
    }
  };
  LatticeOptimum<N> best;
  std::priority_queue<Open> open;
  const auto try_point = [&](const LatticePoint<N>& point) {
    if (problem.bound({point, point}, best.error) >= best.error) return;
    const double error = problem.error(point, best.error);
    ++best.evaluated;
    if (error < best.error) {
      best.error = error;
      best.point = point;
    }
  };
  const auto add = [&](const LatticeBox<N>& box) {
    const double bound = problem.bound(box, best.error);
    ++best.boxes;
    if (bound < best.error) open.push({bound, best.boxes, box});
  };
  for (const auto& start : starts) try_point(start);
  add(all);
  while (!open.empty() && open.top().bound < best.error) {
    if (best.boxes >= limit) return best;
    constexpr long often = 4096;
    if (best.boxes % often < 2) checkpoint();
    const LatticeBox<N> box = open.top().box;
    open.pop();
    try_point(box.centre());
    if (box.is_point()) continue;
    const std::size_t side = box.widest();
    LatticeBox<N> low = box, high = box;
    low.upper[side] = box.centre()[side];
    high.lower[side] = low.upper[side] + 1;
    add(low);
    add(high);
  }
  best.is_proven = true;
  return best;
}

/// If the whole lattice is too large to search: steps to each side of the best point so far.
inline constexpr std::int64_t neighbourhood = 16;
/// The most parameters for which the whole lattice can be searched.
inline constexpr std::size_t most_dimensions = 2;
/// The most neighbourhoods of a search.
inline constexpr int most_moves = 100;

template <std::size_t N>
struct FormatOptimum {
  LatticePoint<N> point{};
  bool is_proven = false;  ///< no other constants among those searched are better
  std::string searched;    ///< the set of constants that was searched, in words
  long evaluated = 0;      ///< constants whose error was computed
};

/// Searches the whole lattice up to `last`, or else neighbourhoods until the best point is the centre of its
/// neighbourhood.
template <std::size_t N>
FormatOptimum<N> search_format(const LatticeProblem<N>& problem, std::int64_t last,
                               const std::vector<LatticePoint<N>>& starts, const NumberFormat& format,
                               long limit, const Checkpoint& checkpoint) {
  LatticeOptimum<N> best;
  if constexpr (N <= most_dimensions) {
    LatticeBox<N> all;
    all.lower.fill(-last);
    all.upper.fill(last);
    best = search_lattice<N>(problem, all, starts, limit, checkpoint);
    const std::string searched = format.kind == NumberFormat::Kind::decimal
                                     ? "all numbers of the format from 1e-20 to 1e21 in magnitude, and 0"
                                     : "all finite numbers of the format";
    if (best.is_proven) return {best.point, true, searched, best.evaluated};
  }
  std::vector<LatticePoint<N>> from = starts;
  if (std::isfinite(best.error)) from.push_back(best.point);
  LatticePoint<N> centre = from.back();
  FormatOptimum<N> found{
      .searched = "the constants within " + std::to_string(neighbourhood) + " steps of the format",
      .evaluated = best.evaluated};
  for (int move = 0; move < most_moves; ++move) {
    LatticeBox<N> box;
    for (std::size_t i = 0; i < N; ++i) {
      box.lower[i] = std::max(-last, centre[i] - neighbourhood);
      box.upper[i] = std::min(last, centre[i] + neighbourhood);
    }
    best = search_lattice<N>(problem, box, from, limit, checkpoint);
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
