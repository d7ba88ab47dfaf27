#pragma once

#include <cstddef>
#include <vector>

#include "fit/formula/graph.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/proof/interval.hpp"

/// Where a formula is not continuous.
namespace shadefit {

/// The operations of a graph that are not continuous in their operands. Poles need no care: there values or
/// slopes are unbounded.
class Jumps {
 public:
  Jumps() = default;
  explicit Jumps(const Graph& graph);

  bool empty() const { return nodes_.empty(); }

  /// The nodes that decide on which side of its jump each operation is: outputs for a tape.
  std::vector<int> deciding_nodes() const;

  /// Whether an operation may jump within the intervals of a program's last run. The program's outputs from
  /// `first` on are the deciding nodes.
  bool may_happen(const TapeProgram<Interval>& program, std::size_t first) const;

 private:
  std::vector<GraphNode> nodes_;
};

}  // namespace shadefit
