#include <variant>

#include "fit/solve/solve.hpp"

namespace shadefit {

Solution solve_under(const AnyFamily& any, const Metric& metric, const Cosine<double>& top,
                     const Cosine<double>& bottom) {
  return std::visit(
      [&]<class F>(const F& family) {
        const Weight weight(metric.weight, {bottom.cos_theta, top.cos_theta});
        return solve_between(Under<F>{family, metric.error, weight, given_parameters<F>(metric.constraints)},
                             metric, top, bottom);
      },
      any);
}

}  // namespace shadefit
