#pragma once

#include <cstddef>
#include <span>

#include "fit/formula/graph.hpp"
#include "fit/scalars/two_lanes.hpp"

namespace shadefit {

/// The inner loops of a fit over many nodes, in the widest registers of the machine: of four doubles where it
/// has AVX2, else of two. Both do the same operations in the same order on each number, so all bits are the
/// same.
struct WideLoops {
  /// Arrays are a whole number of groups of so many packs.
  static constexpr std::size_t group = 4;

  /// result[i] = a[i] op b[i], where `is_wide(op)`; or -a[i].
  void (*combine)(Operation op, const TwoLanes* a, const TwoLanes* b, TwoLanes* result, std::size_t groups);

  /// result[i] = exp2(x[i]), with the bits of `Scalar<TwoLanes>`.
  void (*exp2)(const TwoLanes* x, TwoLanes* result, std::size_t groups);

  /// Adds weights[k] * columns[i][k] * columns[j][k] to the sum of (i, j), for each j <= i: (0, 0), (1, 0),
  /// (1, 1), (2, 0) .. A sum has `group` parts: part p is that of the p-th packs of the groups. At most
  /// `most_groups` at a time.
  void (*add_products)(const TwoLanes* weights, std::span<const TwoLanes* const> columns, TwoLanes* sums,
                       std::size_t groups);
  static constexpr std::size_t most_groups = 16;
};

/// Whether `combine` has this operation.
constexpr bool is_wide(Operation op) {
  return op == Operation::add || op == Operation::subtract || op == Operation::multiply ||
         op == Operation::divide || op == Operation::negate;
}

/// In registers of two doubles.
const WideLoops& loops_of_two();
/// In registers of four doubles; null if the machine has none.
const WideLoops* loops_of_four();

inline const WideLoops& wide_loops() {
  static const WideLoops& widest = loops_of_four() != nullptr ? *loops_of_four() : loops_of_two();
  return widest;
}

}  // namespace shadefit
