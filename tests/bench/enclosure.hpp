#pragma once

#include <concepts>
#include <functional>

#include "fit/proof/interval.hpp"
#include "fit/scalars/jet.hpp"
#include "tests/bench/box.hpp"

/// The proven maximum of the magnitude of a function of the cosine, by interval branch and bound.
namespace shadefit {

/// [lower, upper] contains max |f|.
struct Enclosure {
  double lower, upper;
};

/// A continuous function of the cosine, type-erased so that the search is compiled only once. Where it has a
/// kink, its derivatives enclose those of both branches.
class EnclosedFunction {
 public:
  using Jet = ceres::Jet<Interval, 1>;

  /// `f` is a template over the cosine's scalar.
  template <class F>
  requires(!std::same_as<F, EnclosedFunction>) EnclosedFunction(const F& f) : value_(f), jet_(f) {}

  Interval operator()(const Cosine<Interval>& c) const { return value_(c); }
  Jet operator()(const Cosine<Jet>& c) const { return jet_(c); }

 private:
  std::function<Interval(const Cosine<Interval>&)> value_;
  std::function<Jet(const Cosine<Jet>&)> jet_;
};

/// Encloses max |f| over a domain, to a relative width if 20 000 boxes are enough.
Enclosure enclose_largest(const EnclosedFunction& f, const Domain& domain, double width);

}  // namespace shadefit
