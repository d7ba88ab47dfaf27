#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

/// Gauss rules for integrands with one narrow place.
namespace shadefit {

struct RuleNode {
  double position, weight;
};

/// The Gauss-Legendre rule on [0, 1] with at least `count` nodes; 16, 24, 32 .. of them. Throws
/// std::out_of_range for more than 288.
const std::vector<RuleNode>& gauss_on_unit(std::size_t count);

/// Calls visit(position, weight) for nodes on [0, end] that lie closer and closer towards 0, down to `scale`,
/// where the integrand is narrow: position = scale sinh(k t) with a Gauss rule in t. `nodes(k)` says how many
/// nodes there are at least.
template <class Count, class Visit>
void visit_graded(double scale, double end, const Count& nodes, const Visit& visit) {
  const double k = std::asinh(end / scale);
  for (const RuleNode& node : gauss_on_unit(nodes(k))) {
    const double rising = std::exp(k * node.position), falling = 1 / rising;
    visit(scale * (rising - falling) / 2, node.weight * k * scale * (rising + falling) / 2);
  }
}

}  // namespace shadefit
