#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

/// Gauss-Legendre rules of rising size, computed by Boost.Math.
namespace shadefit {

/// The sizes at hand. The first two are for looking around; from the third on each is half as large again as
/// the one before, so that two neighbours that agree have both converged.
inline constexpr std::array<unsigned, 8> gauss_sizes{6, 12, 26, 38, 56, 84, 126, 190};

/// Calls visit(position, weight) for each node of the rule of `size` points on [0, 1], in rising position;
/// the weights sum to 1. Nodes are made once in long double, so that a double has them correctly rounded.
template <class T, unsigned size, class Visit>
void visit_gauss_rule(const Visit& visit) {
  static_assert(size % 2 == 0, "an odd rule has a node in the middle, which stands once");
  using Rule = boost::math::quadrature::gauss<long double, size>;
  const auto& x = Rule::abscissa();  // the positive zeros on [-1, 1], rising
  const auto& w = Rule::weights();
  for (auto i = x.size(); i-- > 0;) visit(static_cast<T>((1 - x[i]) / 2), static_cast<T>(w[i] / 2));
  for (std::size_t i = 0; i < x.size(); ++i) visit(static_cast<T>((1 + x[i]) / 2), static_cast<T>(w[i] / 2));
}

/// The same for the rule of gauss_sizes[index]. Throws std::out_of_range where there is none.
template <class T, class Visit>
void visit_gauss_rule(std::size_t index, const Visit& visit) {
  const auto visit_if = [&]<std::size_t I>(std::integral_constant<std::size_t, I>) {
    if (I == index) visit_gauss_rule<T, gauss_sizes[I]>(visit);
    return I == index;
  };
  const bool is_found = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (visit_if(std::integral_constant<std::size_t, I>{}) || ...);
  }
  (std::make_index_sequence<gauss_sizes.size()>{});
  if (!is_found) throw std::out_of_range("no Gauss rule of that index");
}

template <class T>
struct GaussNode {
  T position;
  T weight;
};

/// The nodes of the rule of gauss_sizes[index], for those who come back to them.
template <class T>
std::vector<GaussNode<T>> gauss_nodes(std::size_t index) {
  std::vector<GaussNode<T>> nodes;
  visit_gauss_rule<T>(index, [&](const T& position, const T& weight) {
    nodes.push_back({position, weight});
  });
  return nodes;
}

}  // namespace shadefit
