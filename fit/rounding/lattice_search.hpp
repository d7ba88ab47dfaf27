#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fit/rounding/lattice.hpp"
#include "fit/support/checkpoint.hpp"

/// The best point of a lattice, by branch and bound, and with it the best constants of a number format.
namespace shadefit {

/// The most parameters of a form whose constants are searched for.
inline constexpr std::size_t most_rounded_parameters = 6;

/// An index for each parameter.
using LatticePoint = boost::container::small_vector<std::int64_t, most_rounded_parameters>;

/// The points between two corners, both included.
struct LatticeBox {
  LatticePoint lower;
  LatticePoint upper;

  bool is_point() const { return lower == upper; }
  std::size_t widest() const {
    std::size_t widest = 0;
    for (std::size_t i = 1; i < lower.size(); ++i) {
      if (upper[i] - lower[i] > upper[widest] - lower[widest]) widest = i;
    }
    return widest;
  }
  LatticePoint centre() const {
    LatticePoint point = lower;
    for (std::size_t i = 0; i < point.size(); ++i) point[i] += (upper[i] - lower[i]) / 2;
    return point;
  }
};

/// A type-erased problem: the search is compiled once.
struct LatticeProblem {
  /// A lower bound of the error of all points of the box. May return early with any value >= `best`.
  std::function<double(const LatticeBox& box, double best)> bound;
  /// The error of a point, or any value >= `best` if the point is no better.
  std::function<double(const LatticePoint& point, double best)> error;
};

struct FormatOptimum {
  LatticePoint point = {};
  bool is_proven = false;  ///< no other constants among those searched are better
  std::string searched;    ///< the set of constants that was searched, in words
  long evaluated = 0;      ///< constants whose error was computed
};

/// Searches the whole lattice up to `last`, or else neighbourhoods until the best point is the centre of its
/// neighbourhood. `limit` is that of the boxes of a search.
FormatOptimum search_format(const LatticeProblem& problem, std::int64_t last,
                            const std::vector<LatticePoint>& starts, const NumberFormat& format, long limit,
                            const Checkpoint& checkpoint);

}  // namespace shadefit
