#pragma once

#include <ceres/jet.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>

#include "fit/least_squares/error_scale.hpp"
#include "fit/least_squares/sums.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/two_lanes.hpp"

/// The continuous least-squares problem at the nodes of a Gauss rule: sums stand for the integrals.
namespace shadefit {

/// A family sampled at the nodes of a Gauss rule on each panel of a domain. The total of the measure is 1.
/// The scale of the error is part of the weights of the nodes: what is squared and summed is the same. Every
/// rule has an even number of nodes, because two are computed together in double.
///
/// Functions that run for every node are inlined: without that, calls of the products of Jets take a fifth of
/// a fit.
template <class F, class T>
class SampledProblem {
 public:
  static constexpr int N = static_cast<int>(F::parameters.size());
  using Parameters = std::array<T, N>;

  SampledProblem(const F& family, std::span<const Substitution> panels, unsigned rule_size,
                 const ErrorScale& scale = {})
      : family_(family) {
    long double total = 0;
    for (const Substitution& panel : panels) total += panel.total();
    const auto share = static_cast<T>(1 / total);
    nodes_.reserve(panels.size() * rule_size / lanes);
    std::array<T, lanes> positions, weights;
    std::size_t filled = 0;
    for (const Substitution& panel : panels) {
      visit_gauss_rule<T>(rule_size, [&](const T& position, const T& weight) {
        positions[filled] = position;
        weights[filled] = weight;
        if (++filled < lanes) return;
        filled = 0;
        const auto place = panel.at(Lanes::joined(positions));
        const auto sample = family.sample(place.cosine);
        const S measure = Lanes::joined(weights) * place.density * S(share);
        nodes_.push_back(
            {sample, scale.is_one() ? measure : measure * square_of(scale, place.cosine, sample)});
      });
    }
  }

  static Parameters array_of(std::span<const T> p) {
    Parameters values;
    std::copy_n(p.begin(), values.size(), values.begin());
    return values;
  }

  std::size_t size() const { return nodes_.size() * lanes; }
  T weight(std::size_t i) const { return Lanes::lane(nodes_[i / lanes].weight, i % lanes); }

  /// r, and its derivatives at all nodes, parameter by parameter
  [[gnu::flatten]] void errors(const Parameters& p, std::span<T> r, std::span<T> slopes) const {
    const auto seeds = seeded(p);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto jet = error(nodes_[i], seeds);
      for (std::size_t l = 0; l < lanes; ++l) {
        r[i * lanes + l] = Lanes::lane(jet.a, l);
        for (std::size_t j = 0; j < N; ++j)
          slopes[j * size() + i * lanes + l] = Lanes::lane(jet.v[static_cast<int>(j)], l);
      }
    }
  }

  /// sum of w r^2
  T square(const Parameters& p) const {
    std::array<S, N> q;
    std::copy(p.begin(), p.end(), q.begin());
    S sum = integer<S>(0);
    for (const auto& node : nodes_) {
      const S r = error(node, q);
      sum += node.weight * r * r;
    }
    return Lanes::sum(sum);
  }

  /// and of w r r_i and w r_i r_j, by Jets
  [[gnu::flatten]] Sums<T> gradient(const Parameters& p) const {
    const auto seeds = seeded(p);
    NodeSums sums;
    for (const auto& node : nodes_) {
      const auto r = error(node, seeds);
      const S weighted = node.weight * r.a;
      sums.square += weighted * r.a;
      for (int i = 0; i < N; ++i) {
        sums.gradient[i] += weighted * r.v[i];
        for (int j = 0; N > 1 && j <= i; ++j) sums.hessian(i, j) += node.weight * r.v[i] * r.v[j];
      }
    }
    return total(sums);
  }

  /// and of w (r_i r_j + r r_ij), by Jets of Jets
  Sums<T> derivatives(const Parameters& p) const {
    using First = ceres::Jet<S, N>;
    using Second = ceres::Jet<First, N>;
    std::array<Second, N> seeds;
    for (int i = 0; i < N; ++i) {
      seeds[static_cast<std::size_t>(i)] = Second(First(S(p[static_cast<std::size_t>(i)]), i));
      seeds[static_cast<std::size_t>(i)].v[i] = First(S(1));
    }
    NodeSums sums;
    for (const auto& node : nodes_) {
      const Second r = error(node, seeds);
      const S w = node.weight;
      sums.square += w * r.a.a * r.a.a;
      for (int i = 0; i < N; ++i) {
        sums.gradient[i] += w * r.a.a * r.a.v[i];
        for (int j = 0; j <= i; ++j) sums.hessian(i, j) += w * (r.a.v[i] * r.a.v[j] + r.a.a * r.v[i].v[j]);
      }
    }
    return total(sums);
  }

 private:
  using Lanes = SideBySide<T>;
  using S = typename Lanes::Type;
  static constexpr std::size_t lanes = Lanes::size;

  struct Node {
    typename F::template Sample<S> sample;
    S weight;
  };

  template <class P>
  P error(const Node& node, const std::array<P, N>& p) const {
    return family_.error(node.sample, p);
  }

  static std::array<ceres::Jet<S, N>, N> seeded(const Parameters& p) {
    std::array<ceres::Jet<S, N>, N> seeds;
    for (std::size_t i = 0; i < N; ++i) seeds[i] = {S(p[i]), static_cast<int>(i)};
    return seeds;
  }

  /// In each lane; the lower half of the Hessian.
  struct NodeSums {
    S square = S(0);
    Eigen::Matrix<S, N, 1> gradient = Eigen::Matrix<S, N, 1>::Zero();
    Eigen::Matrix<S, N, N> hessian = Eigen::Matrix<S, N, N>::Zero();
  };

  static Sums<T> total(const NodeSums& s) {
    Sums<T> all{Lanes::sum(s.square), ParameterVector<T>(N), ParameterMatrix<T>(N, N)};
    for (int i = 0; i < N; ++i) {
      all.gradient[i] = Lanes::sum(s.gradient[i]);
      for (int j = 0; j <= i; ++j) all.hessian(i, j) = all.hessian(j, i) = Lanes::sum(s.hessian(i, j));
    }
    return all;
  }

  /// (scaled error / error)^2 at a place.
  S square_of(const ErrorScale& scale, const Cosine<S>& c, const typename F::template Sample<S>& s) const {
    S factor = scale.weight.at(c.cos_theta);
    if (scale.kind == Error::relative) factor *= S(family_.relative_scale(s));
    return factor * factor;
  }

  F family_;
  /// Room for the rules that nearly all fits need.
  boost::container::small_vector<Node, 30 / lanes> nodes_;
};

}  // namespace shadefit
