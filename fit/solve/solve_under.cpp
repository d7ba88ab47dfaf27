#include <algorithm>
#include <array>
#include <cstddef>

#include "fit/families/families.hpp"
#include "fit/solve/solve.hpp"

namespace shadefit {
namespace {

/// `M`: as many parameters as may be free.
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

template <class F>
Solution solve_under(const F& family, const Metric& metric, const Cosine<double>& top,
                     const Cosine<double>& bottom) {
  return solve_with_at_most<F::parameters.size()>(family, metric, top, bottom);
}

template Solution solve_under(const SgOffset&, const Metric&, const Cosine<double>&, const Cosine<double>&);
template Solution solve_under(const FresnelOneTerm&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);
template Solution solve_under(const FresnelQuadratic&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);
template Solution solve_under(const PhongBlinn&, const Metric&, const Cosine<double>&, const Cosine<double>&);
template Solution solve_under(const SgScaled&, const Metric&, const Cosine<double>&, const Cosine<double>&);
template Solution solve_under(const FresnelCubic&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);
template Solution solve_under(const FresnelQuartic&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);
template Solution solve_under(const FresnelFourth&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);
template Solution solve_under(const FresnelSquare&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);
template Solution solve_under(const FresnelRational&, const Metric&, const Cosine<double>&,
                              const Cosine<double>&);

}  // namespace shadefit
