#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

/// Gauss-Legendre rules of rising size, computed by Boost.Math.
namespace shadefit {

template <class T>
struct GaussNode {
  T position;  ///< in (0, 1)
  T weight;    ///< the weights of a rule sum to 1
};

/// The sizes that a convergence check climbs, each half as large again as the one before.
inline constexpr std::array<unsigned, 6> gauss_sizes{24, 36, 54, 80, 120, 180};

/// The rule of gauss_sizes[Index] on [0, 1], in rising position.
template <class T, std::size_t Index>
std::vector<GaussNode<T>> gauss_nodes() {
  using Rule = boost::math::quadrature::gauss<T, gauss_sizes[Index]>;
  std::vector<GaussNode<T>> nodes;
  const auto& x = Rule::abscissa();  // the positive zeros, rising; every size is even
  const auto& w = Rule::weights();
  nodes.reserve(2 * x.size());
  for (auto i = x.size(); i-- > 0;) nodes.push_back({(1 - x[i]) / 2, w[i] / 2});
  for (std::size_t i = 0; i < x.size(); ++i) nodes.push_back({(1 + x[i]) / 2, w[i] / 2});
  return nodes;
}

/// The rule of gauss_sizes[index].
template <class T>
std::vector<GaussNode<T>> gauss_nodes(std::size_t index) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    std::vector<GaussNode<T>> nodes;
    if (!((I == index && (nodes = gauss_nodes<T, I>(), true)) || ...)) {
      throw std::out_of_range("no Gauss rule of that index");
    }
    return nodes;
  }
  (std::make_index_sequence<gauss_sizes.size()>{});
}

}  // namespace shadefit
