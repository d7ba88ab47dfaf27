#pragma once

#include <array>
#include <cstddef>

#include "approx/cosine.hpp"
#include "fit/least_squares/weight.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"

/// The error of a family as a metric counts it: absolute or relative, times a weight.
namespace shadefit {

struct ErrorScale {
  Error kind = Error::absolute;
  Weight weight = {};

  ErrorScale() = default;
  explicit ErrorScale(const Metric& metric) : kind(metric.error), weight(metric.weight, metric.domain) {}

  bool is_one() const { return kind == Error::absolute && weight.is_one(); }
};

/// sqrt(integral of measure * weight^2 / integral of measure): the scale of a weight.
double scale_of(const Weight& weight, const Metric& metric);

/// The shape of an error on that scale. A relative error does not decay with its target, and is singular
/// where the target is 0. A weight may rise while the target falls. Then panels that double replace the cut.
Shape shape_under(const ErrorScale& scale, Shape shape);

/// The values at a cosine that do not depend on the parameters.
template <class F, class T>
struct ScaledSample {
  typename F::template Sample<T> inner;
  T weight;
};

template <class F, class T>
ScaledSample<F, T> sample_under(const ErrorScale& scale, const F& family, const Cosine<T>& c) {
  return {family.sample(c), scale.weight.at(c.cos_theta)};
}

template <class F, class T, class P, std::size_t N>
P error_under(const ErrorScale& scale, const F& family, const ScaledSample<F, T>& s,
              const std::array<P, N>& p) {
  const P e = scale.kind == Error::relative ? family.relative_error(s.inner, p) : family.error(s.inner, p);
  return scale.weight.is_one() ? e : lift<P>(s.weight) * e;
}

}  // namespace shadefit
