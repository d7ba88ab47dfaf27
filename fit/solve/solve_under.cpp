#include <algorithm>
#include <array>
#include <cstddef>
#include <variant>

#include "fit/solve/solve.hpp"

namespace shadefit {
namespace {

/// `M`: the largest number of free parameters.
template <std::size_t M, class F>
Solution solve_with_at_most(const F& family, const Metric& metric, const Cosine<double>& top,
                            const Cosine<double>& bottom) {
  const auto given = given_parameters<F>(metric.constraints);
  const auto held = static_cast<std::size_t>(
      std::count_if(given.begin(), given.end(), [](const auto& g) { return g.has_value(); }));
  if constexpr (M > 1) {
    if (held + M > given.size()) return solve_with_at_most<M - 1>(family, metric, top, bottom);
  }
  return solve_free(
      Under<F, M>{family, metric.error, Weight(metric.weight, {bottom.cos_theta, top.cos_theta}), given},
      metric, top, bottom);
}

}  // namespace

Solution solve_under(const AnyFamily& any, const Metric& metric, const Cosine<double>& top,
                     const Cosine<double>& bottom) {
  return std::visit(
      [&]<class F>(const F& family) {
        return solve_with_at_most<F::parameters.size()>(family, metric, top, bottom);
      },
      any);
}

}  // namespace shadefit
