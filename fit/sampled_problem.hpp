#pragma once

#include <ceres/jet.h>

#include <Eigen/Core>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>

#include "fit/gauss.hpp"
#include "fit/jet.hpp"
#include "fit/substitution.hpp"

/// The continuous least-squares problem at the nodes of a Gauss rule: sums stand for the integrals.
namespace shadefit {

template <class T, int N>
struct SampledGradient {
  T square = 0;                                                      ///< integral of error^2
  Eigen::Matrix<T, N, 1> gradient = Eigen::Matrix<T, N, 1>::Zero();  ///< of half the square
  /// sum of w r_i r_j: Gauss and Newton's part of the Hessian; lower half
  Eigen::Matrix<T, N, N> slopes = Eigen::Matrix<T, N, N>::Zero();
};

template <class T, int N>
struct SampledDerivatives : SampledGradient<T, N> {
  Eigen::Matrix<T, N, N> hessian = Eigen::Matrix<T, N, N>::Zero();  ///< of half the square
};

/// A family sampled at the nodes of a Gauss rule on each panel of a domain; the measure's total is 1.
template <class F, class T>
class SampledProblem {
 public:
  static constexpr int N = static_cast<int>(F::parameters.size());
  using Parameters = std::array<T, N>;
  using Gradient = SampledGradient<T, N>;
  using Derivatives = SampledDerivatives<T, N>;

  SampledProblem(const F& family, std::span<const Substitution> panels, unsigned rule_size)
      : family_(family) {
    long double total = 0;
    for (const Substitution& panel : panels) total += panel.total();
    const auto share = static_cast<T>(1 / total);
    nodes_.reserve(panels.size() * rule_size);
    for (const Substitution& panel : panels) {
      visit_gauss_rule<T>(rule_size, [&](const T& position, const T& weight) {
        const auto place = panel.at(position);
        nodes_.push_back({family.sample(place.cosine), weight * place.density * share});
      });
    }
  }

  std::size_t size() const { return nodes_.size(); }
  T weight(std::size_t i) const { return nodes_[i].weight; }

  /// r, and its derivatives at all nodes by one parameter after the other
  void errors(const Parameters& p, std::span<T> r, std::span<T> slopes) const {
    const auto seeds = seeded(p);
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const auto jet = error(node, seeds);
      r[node] = jet.a;
      for (std::size_t i = 0; i < N; ++i) slopes[i * nodes_.size() + node] = jet.v[static_cast<int>(i)];
    }
  }

  /// sum of w r^2
  T square(const Parameters& p) const {
    T sum = 0;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const T r = error(node, p);
      sum += nodes_[node].weight * r * r;
    }
    return sum;
  }

  /// and of w r r_i, by Jets
  Gradient gradient(const Parameters& p) const {
    const auto seeds = seeded(p);
    Gradient g;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const auto r = error(node, seeds);
      const T weighted = nodes_[node].weight * r.a;
      g.square += weighted * r.a;
      for (int i = 0; i < N; ++i) {
        g.gradient[i] += weighted * r.v[i];
        for (int j = 0; N > 1 && j <= i; ++j) g.slopes(i, j) += nodes_[node].weight * r.v[i] * r.v[j];
      }
    }
    return g;
  }

  /// and sum of w (r_i r_j + r r_ij), by Jets of Jets
  Derivatives derivatives(const Parameters& p) const {
    using First = ceres::Jet<T, N>;
    using Second = ceres::Jet<First, N>;
    std::array<Second, N> seeds;
    for (int i = 0; i < N; ++i) {
      seeds[static_cast<std::size_t>(i)] = Second(First(p[static_cast<std::size_t>(i)], i));
      seeds[static_cast<std::size_t>(i)].v[i] = First(T(1));
    }
    Derivatives d;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Second r = error(node, seeds);
      const T w = nodes_[node].weight;
      d.square += w * r.a.a * r.a.a;
      for (int i = 0; i < N; ++i) {
        d.gradient[i] += w * r.a.a * r.a.v[i];
        for (int j = 0; j < N; ++j) d.hessian(i, j) += w * (r.a.v[i] * r.a.v[j] + r.a.a * r.v[i].v[j]);
      }
    }
    return d;
  }

 private:
  template <class P>
  P error(std::size_t i, const std::array<P, N>& p) const {
    return family_.error(nodes_[i].sample, p);
  }

  static std::array<ceres::Jet<T, N>, N> seeded(const Parameters& p) {
    std::array<ceres::Jet<T, N>, N> seeds;
    for (std::size_t i = 0; i < N; ++i) seeds[i] = {p[i], static_cast<int>(i)};
    return seeds;
  }

  struct Node {
    typename F::template Sample<T> sample;
    T weight;
  };

  F family_;
  boost::container::small_vector<Node, 30> nodes_;  ///< the rules that nearly all fits end with fit in
};

}  // namespace shadefit
