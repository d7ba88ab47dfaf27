#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "approx/lobe.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/quadrature/integrate.hpp"

/// Least squares against the lobe c^k for kernels with one parameter that are functions of the angle.
namespace shadefit {

/// Nodes over the angle from 0 to pi/2 with the weights of dc = sin(theta) dtheta, whose total is 1. The
/// panels end at theta sqrt(k) = 2, 4, 8, ..: the lobe lies in the first three, and kernels with algebraic
/// tails are smooth on each of the others.
class LobeRule {
 public:
  struct LobeAngle {
    double angle;
    double one_minus_cos;
  };
  struct Node {
    LobeAngle direction;
    double weight;
    double target;  ///< c^k
  };

  explicit LobeRule(double exponent) : exponent_(exponent) {
    const double end = pi<double>() / 2;
    for (double edge = 2 / std::sqrt(exponent); edge < end; edge *= 2) edges_.push_back(edge);
    edges_.push_back(end);
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
      visit_gauss_rule<double>(22, [&](double position, double weight) {
        const LobeAngle direction = direction_at(edges_[i] + position * (edges_[i + 1] - edges_[i]));
        nodes_.push_back(
            {direction, weight * (edges_[i + 1] - edges_[i]) * std::sin(direction.angle), lobe(direction)});
      });
    }
  }

  double exponent() const { return exponent_; }
  const std::vector<Node>& nodes() const { return nodes_; }

  /// An angle, with 1 - c free of cancellation.
  static LobeAngle direction_at(double angle) {
    const double s = std::sin(angle / 2);
    return {angle, 2 * s * s};
  }

  /// c^k.
  double lobe(const LobeAngle& direction) const {
    return power_lobe_near_peak(direction.one_minus_cos, exponent_);
  }

  /// The integral of (kernel - c^k)^2 over the cosine, from the kernel's values at the nodes.
  double square(const std::vector<double>& values) const {
    double sum = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double error = values[i] - nodes_[i].target;
      sum += nodes_[i].weight * error * error;
    }
    return sum;
  }

  /// The same by the other rule, from the kernel as a function of the direction; relative tolerance 1e-9.
  template <class Kernel>
  double square_by_other_rule(const Kernel& kernel) const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
      sum += gauss_kronrod(
                 [&](double angle) {
                   const LobeAngle direction = direction_at(angle);
                   const double error = kernel(direction) - lobe(direction);
                   return error * error * std::sin(angle);
                 },
                 edges_[i], edges_[i + 1], 1e-9, 1e-10 * sum)
                 .value;
    }
    return sum;
  }

 private:
  double exponent_;
  std::vector<double> edges_{0};
  std::vector<Node> nodes_;
};

/// The best parameter p > 0 of a kernel, and the root mean square of its error.
struct KernelFit {
  double parameter;
  double rms;
};

/// Minimises the square over p between `low` and `high`: the best of nine places, even in log p, refined
/// between its neighbours. p gets half the digits of a double, as in every minimum; the rms gets all.
/// `values(p)` gives the kernel at the rule's nodes.
template <class Values>
KernelFit fit_kernel(const LobeRule& rule, const Values& values, double low, double high) {
  constexpr int places = 8;
  const auto square = [&](double log_p) { return rule.square(values(std::exp(log_p))); };
  const double from = std::log(low), step = (std::log(high) - from) / places;
  int best = 0;
  double least = square(from);
  for (int i = 1; i <= places; ++i) {
    const double at = square(from + i * step);
    if (at < least) {
      least = at;
      best = i;
    }
  }
  std::uintmax_t steps = 50;
  const auto found = boost::math::tools::brent_find_minima(
      square, from + std::max(0, best - 1) * step, from + std::min(places, best + 1) * step, 27, steps);
  return {std::exp(found.first), std::sqrt(found.second)};
}

}  // namespace shadefit
