#include "fit/bounds/jumps.hpp"

#include <string_view>

#include "fit/proof/interval_ends.hpp"

namespace shadefit {
namespace {

bool can_jump(const GraphNode& node) {
  const std::string_view name = function_name(node);
  return node.operation == Operation::choice || name == "sign" || name == "floor" || name == "atan2";
}

/// How many operands decide on which side of its jump an operation is: one or two.
std::size_t deciding(const GraphNode& node) {
  return node.operation == Operation::function ? 1 : 2;
}

bool is_one_number(const Interval& x) {
  return is_bounded(x) && lower_end(x) == upper_end(x);
}

/// Whether an operation may jump if its deciding operands lie in `a` and `b`. A single operand is given
/// twice.
bool jumps_on(const GraphNode& node, const Interval& a, const Interval& b) {
  const std::string_view name = function_name(node);
  if (name == "sign") return !is_one_number(signum(a));
  if (name == "floor") return !is_one_number(floor(a));
  // The angle jumps at y = 0, x <= 0, and is continuous on the side of y > 0.
  if (name == "atan2") return !(is_never_negative(a) || upper_end(a) < 0 || lower_end(b) > 0);
  return less(a, b) == Certainty::unknown;
}

}  // namespace

Jumps::Jumps(const Graph& graph) {
  for (const GraphNode& node : graph.nodes()) {
    if (can_jump(node)) nodes_.push_back(node);
  }
}

std::vector<int> Jumps::deciding_nodes() const {
  std::vector<int> deciding_nodes;
  for (const GraphNode& node : nodes_) {
    for (std::size_t i = 0; i < deciding(node); ++i) deciding_nodes.push_back(node.operands[i]);
  }
  return deciding_nodes;
}

bool Jumps::may_happen(const TapeProgram<Interval>& program, std::size_t first) const {
  for (const GraphNode& node : nodes_) {
    const Interval& a = program.output(first);
    const Interval& b = program.output(first + deciding(node) - 1);
    first += deciding(node);
    if (jumps_on(node, a, b)) return true;
  }
  return false;
}

}  // namespace shadefit
