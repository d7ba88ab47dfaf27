#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/solve/weight.hpp"

/// A family as a metric sees it.
namespace shadefit {

/// The given parameters of a family, by their places. The others are free.
template <std::size_t N>
using GivenParameters = std::array<std::optional<double>, N>;

/// A family with the error of a metric: absolute or relative, times the weight. The solvers use it as a
/// family. Of the parameters that they pass, the first `free_count()` are the free ones in their order; the
/// others are not read.
template <class F>
struct Under {
  static constexpr auto parameters = F::parameters;
  static constexpr std::size_t all = parameters.size();
  static constexpr bool is_linear = F::is_linear;

  F family;
  Error error_kind = Error::absolute;
  Weight weight = {};
  GivenParameters<all> given = {};

  template <class T>
  struct Sample {
    typename F::template Sample<T> inner;
    T weight;
  };

  template <class T>
  Sample<T> sample(const Cosine<T>& c) const {
    return {family.sample(c), weight.at(c.cos_theta)};
  }

  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, all>& p) const {
    const auto q = with_given(p);
    const P e = error_kind == Error::relative ? family.relative_error(s.inner, q) : family.error(s.inner, q);
    return weight.is_one() ? e : lift<P>(s.weight) * e;
  }

  template <class T, class P>
  P form(const Sample<T>& s, const std::array<P, all>& p) const {
    return family.form(s.inner, with_given(p));
  }

  template <class T, class P>
  P log_form(const Sample<T>& s, const std::array<P, all>& p) const requires
      requires(const std::array<P, all>& q) {
    family.log_form(s.inner, q);
  }
  { return family.log_form(s.inner, with_given(p)); }

  template <class T, class P>
  P log_ratio(const Sample<T>& s, const std::array<P, all>& p) const requires
      requires(const std::array<P, all>& q) {
    family.log_ratio(s.inner, q);
  }
  { return family.log_ratio(s.inner, with_given(p)); }

  /// A relative error does not decay with its target, and is singular where the target is 0. A weight may
  /// rise while the target falls. Then panels that double replace the cut.
  Shape shape() const {
    Shape shape = family.shape();
    if (error_kind == Error::relative) {
      shape.is_singular_below = shape.end_power > 0;
      shape.concentration = shape.end_power = 0;
    }
    if (weight.is_one()) return shape;
    shape.edges = weight.edges();
    const Domain& domain = weight.domain();
    if (!(shape.concentration > 0)) return shape;
    double length = Substitution::decay / shape.concentration;
    for (double c = domain.upper - length; c > domain.lower; c = domain.upper - length) {
      shape.edges.push_back({c, c});
      length *= 2;
    }
    return shape;
  }

  template <class P>
  P denominator(const P& c, const std::array<P, all>& p) const requires
      requires(const F& f, const std::array<P, all>& q) {
    f.denominator(c, q);
  }
  { return family.denominator(c, with_given(p)); }

  /// With the free parameters first.
  std::array<std::array<double, all>, 3> starts() const {
    auto result = family.starts();
    for (auto& start : result) start = without_given(start);
    return result;
  }

  std::size_t free_count() const {
    return static_cast<std::size_t>(std::count(given.begin(), given.end(), std::nullopt));
  }

  /// All parameters in the family's order, the given ones in their places.
  template <class P>
  std::array<P, all> with_given(const std::array<P, all>& p) const {
    std::array<P, all> q;
    std::size_t next = 0;
    for (std::size_t i = 0; i < all; ++i) q[i] = given[i] ? lift<P>(*given[i]) : p[next++];
    return q;
  }

 private:
  std::array<double, all> without_given(const std::array<double, all>& q) const {
    std::array<double, all> p{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < all; ++i) {
      if (!given[i]) p[next++] = q[i];
    }
    return p;
  }
};

}  // namespace shadefit
