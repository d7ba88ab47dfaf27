#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "fit/support/checkpoint.hpp"

/// The best point of a lattice, by branch and bound.
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

}  // namespace shadefit
