#pragma once

#include <array>

#include "approx/cosine.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/solve/solution.hpp"

/// The solvers of a family, compiled apart from their callers and from each other: in one unit they are each
/// inlined less, and the plain fit takes half as long again.
namespace shadefit {

/// Plain least squares: of the absolute error, without weight, with all parameters free.
template <class F>
Solution solve_plain(const F& family, const Metric& metric);

/// Three points to start from.
template <class F>
using FamilyStarts = std::array<std::array<double, F::parameters.size()>, 3>;

/// The same from other starts than the family's own.
template <class F>
Solution solve_plain_from(const F& family, const Metric& metric, const FamilyStarts<F>& starts);

/// A family under a metric whose places that count lie between `top` and `bottom`.
template <class F>
Solution solve_under(const F& family, const Metric& metric, const Cosine<double>& top,
                     const Cosine<double>& bottom);

}  // namespace shadefit
