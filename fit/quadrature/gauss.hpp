#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// Gauss-Legendre rules of rising size, computed by Boost.Math.
namespace shadefit {

/// The available sizes. All are even: an odd rule has a node in the middle, which would be stored twice.
inline constexpr std::array<unsigned, 12> gauss_sizes{6, 12, 14, 18, 22, 26, 30, 38, 56, 84, 126, 190};

/// Half of a rule on [-1, 1], which is symmetric: the positive zeros in rising order, and their weights.
struct GaussRule {
  std::span<const long double> zeros, weights;
};

/// The rule of `size` points, made once. Throws std::out_of_range where there is none.
GaussRule gauss_rule(unsigned size);

/// Calls visit(position, weight) for each node of the rule of `size` points on [0, 1], in rising position;
/// the weights sum to 1. Nodes are computed in long double, so that their doubles are correctly rounded.
template <class T, class Visit>
void visit_gauss_rule(unsigned size, const Visit& visit) {
  const auto [x, w] = gauss_rule(size);
  for (auto i = x.size(); i-- > 0;) visit(static_cast<T>((1 - x[i]) / 2), static_cast<T>(w[i] / 2));
  for (std::size_t i = 0; i < x.size(); ++i) visit(static_cast<T>((1 + x[i]) / 2), static_cast<T>(w[i] / 2));
}

template <class T>
struct GaussNode {
  T position;
  T weight;
};

/// The nodes of the rule of `size` points as a list.
template <class T>
std::vector<GaussNode<T>> gauss_nodes(unsigned size) {
  std::vector<GaussNode<T>> nodes;
  visit_gauss_rule<T>(size, [&](const T& position, const T& weight) { nodes.push_back({position, weight}); });
  return nodes;
}

}  // namespace shadefit
