#include "fit/rounding/lattice_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace shadefit {
namespace {

/// If the whole lattice is too large to search: steps to each side of the best point so far.
constexpr std::int64_t neighbourhood = 16;
/// The most parameters for which the whole lattice can be searched.
constexpr std::size_t most_dimensions = 2;
/// The most neighbourhoods of a search.
constexpr int most_moves = 100;

struct LatticeOptimum {
  LatticePoint point = {};
  double error = std::numeric_limits<double>::infinity();
  long boxes = 0;          ///< number of bounded boxes
  long evaluated = 0;      ///< points whose error was computed
  bool is_proven = false;  ///< no other point of the box is better
};

/// Best first: the box with the lowest bound is cut at its widest side and its centre is evaluated, which
/// soon gives a good error for pruning. Of points with equal errors the first one stays. Gives up after
/// `limit` boxes; calls `checkpoint` now and then.
LatticeOptimum search_lattice(const LatticeProblem& problem, const LatticeBox& all,
                              const std::vector<LatticePoint>& starts, long limit,
                              const Checkpoint& checkpoint) {
  struct Open {
    double bound;
    long order;
    LatticeBox box;
    bool operator<(const Open& other) const {
      return bound != other.bound ? bound > other.bound : order > other.order;
    }
  };
  LatticeOptimum best{.point = LatticePoint(all.lower.size())};
  std::priority_queue<Open> open;
  const auto try_point = [&](const LatticePoint& point) {
    if (problem.bound({point, point}, best.error) >= best.error) return;
    const double error = problem.error(point, best.error);
    ++best.evaluated;
    if (error < best.error) {
      best.error = error;
      best.point = point;
    }
  };
  const auto add = [&](const LatticeBox& box) {
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
    const LatticeBox box = open.top().box;
    open.pop();
    try_point(box.centre());
    if (box.is_point()) continue;
    const std::size_t side = box.widest();
    LatticeBox low = box, high = box;
    low.upper[side] = box.centre()[side];
    high.lower[side] = low.upper[side] + 1;
    add(low);
    add(high);
  }
  best.is_proven = true;
  return best;
}

}  // namespace

FormatOptimum search_format(const LatticeProblem& problem, std::int64_t last,
                            const std::vector<LatticePoint>& starts, const NumberFormat& format, long limit,
                            const Checkpoint& checkpoint) {
  LatticeOptimum best;
  const std::size_t size = starts.front().size();
  if (size <= most_dimensions) {
    const LatticeBox all{LatticePoint(size, -last), LatticePoint(size, last)};
    best = search_lattice(problem, all, starts, limit, checkpoint);
    const std::string searched = format.kind == NumberFormat::Kind::decimal
                                     ? "all numbers of the format from 1e-20 to 1e21 in magnitude, and 0"
                                     : "all finite numbers of the format";
    if (best.is_proven) return {best.point, true, searched, best.evaluated};
  }
  std::vector<LatticePoint> from = starts;
  if (std::isfinite(best.error)) from.push_back(best.point);
  LatticePoint centre = from.back();
  FormatOptimum found{
      .searched = "the constants within " + std::to_string(neighbourhood) + " steps of the format",
      .evaluated = best.evaluated};
  for (int move = 0; move < most_moves; ++move) {
    LatticeBox box{centre, centre};
    for (std::int64_t& index : box.lower) index = std::max(-last, index - neighbourhood);
    for (std::int64_t& index : box.upper) index = std::min(last, index + neighbourhood);
    best = search_lattice(problem, box, from, limit, checkpoint);
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
