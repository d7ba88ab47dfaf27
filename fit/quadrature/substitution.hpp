#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "approx/cosine.hpp"
#include "approx/scalar.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/jet.hpp"

/// The change of variable that makes an integrand over c smooth, so that Gauss-Legendre converges.
namespace shadefit {

/// The behaviour of a family over c, as the substitution needs it.
struct Shape {
  /// The integrand falls at least as fast as exp(-concentration (1 - c)) from the peak; 0: it is not
  /// concentrated.
  double concentration = 0;
  /// It behaves as c^end_power at c = 0. It is smooth there if this is a whole number.
  double end_power = 0;
  /// A cosine at which the domain is split.
  struct Joint {
    double cosine;
    bool is_kink = false;  ///< there is a kink, with the behaviour of a square root on the side of the peak
  };
  std::optional<Joint> joint = std::nullopt;
  /// It is singular at c = 0, below its domain: a lobe's relative error has log c and powers of 1/c.
  bool is_singular_below = false;
  /// A place where a weight on the error is not smooth. The part towards the peak ends at `above`, the other
  /// begins at `below`: the same place or the next double. On both sides it is smooth in the `power`-th root
  /// of the distance.
  struct Edge {
    double above, below;
    int power = 1;
  };
  /// In falling order. With an edge, nothing is cut off, because a weight may raise the tail.
  std::vector<Edge> edges = {};

  /// The same with the roots that a derivative needs. Higher roots draw all nodes to an edge.
  Shape with_square_roots() const {
    Shape shape = *this;
    for (Edge& edge : shape.edges) edge.power = std::min(edge.power, 2);
    return shape;
  }

  /// For a search, which needs no smoothness: split at a kink only.
  Shape for_search() const {
    Shape shape = with_square_roots();
    if (joint && !joint->is_kink) shape.joint.reset();
    return shape;
  }
};

/// A map of s in [0, 1] onto the domain: s = 0 at its upper end (the peak), s = 1 at its lower end.
///
/// The variable is y = 1 - c for the cosine measures and theta for the angle.
/// - A concentrated integrand is cut where it has fallen below exp(-decay).
/// - A power c^k with k not whole is singular at c = 0. There c (or the angle from the horizon) becomes the
/// q-th
///   power of 1 - s with q (k + 1) >= 8, after which Gauss-Legendre of n nodes converges like n^-16.
/// - An edge of a weight, such as the end c = 1 of sqrt(1 - c), is smoothed in the same way, at either end of
/// a panel.
/// - A singularity below the domain is moved away from it: c is the eighth power of a variable that is linear
///   in s.
class Substitution {
 public:
  Substitution(const Metric& metric, const Shape& shape);

  /// The domain in panels, on each of which the integrand is smooth: one, one more if the joint is inside,
  /// and one more for each edge inside.
  static std::vector<Substitution> panels(const Metric& metric, const Shape& shape);

  /// The cosine measure between two places that are known to full precision, not cut off; in panels as above.
  static std::vector<Substitution> between(const Cosine<double>& top, const Cosine<double>& bottom,
                                           const Shape& shape = {});

  /// exp(-48) = 1.4e-21; with the factor t^3 of a gradient, t = k(1-c), the cut moves a fit by 2e-17 of
  /// itself.
  static constexpr double decay = 48;

  template <class T>
  struct Place {
    Cosine<T> cosine;
    T density;  ///< of the measure, per ds
  };

  /// The cosine at s; T may carry derivatives with respect to s.
  template <class T>
  Place<T> at(const T& s) const {
    const T one = integer<T>(1);
    const T start = lift<T>(start_), range = one - start, remaining = one - s;
    const T u = start + range * (is_rooted_at_peak_ ? s : remaining);
    // 1 - u^q = (1 - u) (1 + u + .. + u^(q-1)): the distance from the other end without cancellation
    const T rest_of_u = range * (is_rooted_at_peak_ ? remaining : s);
    T sum = one, last = one;  // last = u^(q-1)
    for (int i = 1; i < power_; ++i) {
      sum = sum * u + one;
      last = last * u;
    }
    const T length = lift<T>(length_);
    const T from_other = length * (rest_of_u * sum);
    const T from_root = length * (u * last);
    const T& from_peak = is_rooted_at_peak_ ? from_root : from_other;
    const T& from_end = is_rooted_at_peak_ ? from_other : from_root;
    const T density = length * range * integer<T>(power_) * last;
    const T y = lift<T>(near_) + from_peak;
    const T rest = lift<T>(rest_) + from_end;
    if (measure_ == Measure::cosine) return {{rest, y}, density};
    if (measure_ == Measure::cosine_weighted) return {{rest, y}, rest * density};
    // Near the horizon the cosine is the sine of the distance to it; near the peak it is 1 minus its
    // distance.
    const T half_sine = sin(y / integer<T>(2));
    const T one_minus_cos = integer<T>(2) * half_sine * half_sine;
    const T cos_theta = choose(
        less(y, rest), [&] { return one - one_minus_cos; }, [&] { return sin(rest); });
    return {{cos_theta, one_minus_cos}, density};
  }

  /// The measure of the whole domain, cut or not.
  long double total() const { return total_; }

 private:
  /// The panels between the edges of a shape; `piece` makes one from its two ends.
  template <class Piece>
  static std::vector<Substitution> between_edges(const Cosine<double>& top, const Cosine<double>& bottom,
                                                 const Shape& shape, const Piece& piece);

  /// Of a singularity (1 - c)^p or c^p with p > -1.
  static int smoothing_power(double p) { return std::max(1, static_cast<int>(std::ceil(8 / (1 + p)))); }

  Measure measure_;
  int power_ = 1;                   ///< q
  bool is_rooted_at_peak_ = false;  ///< the end that the q-th power is counted from: s = 0, not s = 1
  long double near_ = 0;            ///< the variable at s = 0
  long double length_ = 1;          ///< and from there to where u is 0, or 1 where it is rooted at the peak
  long double rest_ = 0;            ///< from there to c = 0
  long double start_ = 0;           ///< u at the end that the power is counted from
  long double total_ = 1;
};

template <class Piece>
std::vector<Substitution> Substitution::between_edges(const Cosine<double>& top, const Cosine<double>& bottom,
                                                      const Shape& shape, const Piece& piece) {
  std::vector<Shape::Edge> edges = shape.edges;
  if (shape.joint) edges.push_back({shape.joint->cosine, shape.joint->cosine, shape.joint->is_kink ? 2 : 1});
  if (bottom.cos_theta == 0 && shape.end_power != std::floor(shape.end_power))
    edges.push_back({0, 0, smoothing_power(shape.end_power)});
  std::ranges::stable_sort(edges, std::greater(), &Shape::Edge::above);

  std::vector<Substitution> result;
  Cosine<double> from = top;
  int from_power = 1;
  const auto add = [&](const Cosine<double>& to, int q, bool is_rooted_at_peak) {
    if (!(from.cos_theta > to.cos_theta)) return;
    result.push_back(piece(from, to));
    result.back().power_ = q;
    result.back().is_rooted_at_peak_ = is_rooted_at_peak;
    from = to;
  };
  // A root draws the nodes to its end; the other half of a panel needs its own rule.
  const auto go_to = [&](const Cosine<double>& to, int q) {
    if (std::max(from_power, q) > 1) {
      const double middle = to.cos_theta + (from.cos_theta - to.cos_theta) / 2;
      add({middle, 1 - middle}, from_power, true);
    }
    add(to, q, false);
  };
  int last_power = 1;
  for (const Shape::Edge& edge : edges) {
    if (edge.above >= top.cos_theta) {
      from_power = std::max(from_power, edge.power);
    } else if (edge.below <= bottom.cos_theta) {
      last_power = std::max(last_power, edge.power);
    } else {
      go_to({edge.above, 1 - edge.above}, edge.power);
      from = {edge.below, 1 - edge.below};
      from_power = edge.power;
    }
  }
  go_to(bottom, last_power);
  return result;
}

inline std::vector<Substitution> Substitution::between(const Cosine<double>& top,
                                                       const Cosine<double>& bottom, const Shape& shape) {
  if (!shape.edges.empty())
    return between_edges(top, bottom, shape, [](const Cosine<double>& from, const Cosine<double>& to) {
      return between(from, to).front();
    });
  const auto& joint = shape.joint;
  if (joint && bottom.cos_theta < joint->cosine && joint->cosine < top.cos_theta) {
    const Cosine<double> middle{joint->cosine, 1 - joint->cosine};
    std::vector<Substitution> result = between(top, middle);
    if (joint->is_kink) result.front().power_ = 2;
    result.push_back(between(middle, bottom).front());
    return result;
  }
  Substitution result(Metric{}, Shape{});
  result.near_ = top.one_minus_cos;
  result.length_ = bottom.one_minus_cos - top.one_minus_cos;
  result.rest_ = bottom.cos_theta;
  result.total_ = result.length_;
  return {result};
}

inline std::vector<Substitution> Substitution::panels(const Metric& metric, const Shape& shape) {
  const Domain& domain = metric.domain;
  if (!shape.edges.empty())
    return between_edges({domain.upper, 1 - domain.upper}, {domain.lower, 1 - domain.lower}, shape,
                         [&](const Cosine<double>& from, const Cosine<double>& to) {
                           Metric part = metric;
                           part.domain = {to.cos_theta, from.cos_theta};
                           return Substitution(part, {});
                         });
  const auto& joint = shape.joint;
  if (!joint || joint->cosine <= domain.lower || joint->cosine >= domain.upper) return {{metric, shape}};
  Metric above = metric, below = metric;
  above.domain.lower = below.domain.upper = joint->cosine;
  std::vector<Substitution> result{{above, {}}, {below, {}}};
  if (joint->is_kink) result.front().power_ = 2;  // the square root of a square is smooth
  return result;
}

inline Substitution::Substitution(const Metric& metric, const Shape& shape) : measure_(metric.measure) {
  const long double top = 1.0L - static_cast<long double>(metric.domain.upper);
  const long double bottom = 1.0L - static_cast<long double>(metric.domain.lower);
  const long double cut =
      shape.concentration > 0 ? top + static_cast<long double>(decay / shape.concentration) : bottom;
  const bool is_cut = cut < bottom;
  // theta = 2 asin(sqrt(y/2)), without cancellation near the peak
  const auto variable = [&](long double y) {
    return measure_ == Measure::angle ? 2 * std::asin(std::sqrt(y / 2)) : y;
  };
  near_ = variable(top);
  length_ = variable(is_cut ? cut : bottom) - near_;
  rest_ = metric.domain.lower == 0 && !is_cut ? 0.0L : variable(1.0L) - near_ - length_;
  total_ = variable(bottom) - near_;
  if (measure_ == Measure::cosine_weighted)
    total_ *= ((1 - top) + (1 - bottom)) / 2;  // upper^2/2 - lower^2/2
  const bool is_singular = shape.end_power != std::floor(shape.end_power);
  if (is_singular && !is_cut && metric.domain.lower == 0) {
    power_ = smoothing_power(shape.end_power);
  }
  if (shape.is_singular_below && metric.domain.lower > 0) {
    power_ = 8;
    length_ = variable(1.0L) - near_;
    rest_ = 0;
    const auto lower = static_cast<long double>(metric.domain.lower);
    start_ = std::pow((measure_ == Measure::angle ? std::asin(lower) : lower) / length_, 0.125L);
  }
}

}  // namespace shadefit
