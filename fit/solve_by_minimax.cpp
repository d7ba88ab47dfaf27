#include <variant>

#include "fit/minimax/minimax_problem.hpp"
#include "fit/solve.hpp"

namespace shadefit {

Solution solve_by_minimax(const AnyFamily& any, const Metric& metric, const Cosine<double>& top,
                          const Cosine<double>& bottom) {
  Metric narrowed = metric;
  narrowed.domain = {bottom.cos_theta, top.cos_theta};
  const Candidate start = start_of_minimax(any, narrowed);
  return std::visit(
      [&]<class F>(const F& family) {
        const MinimaxOptimum optimum = Minimax<F>(family, metric, top, bottom).solve(start);
        const auto p = optimum.parameters.begin();
        Solution solution{.parameters = {p, p + F::parameters.size()},
                          .status = optimum.status,
                          .iterations = optimum.iterations,
                          .digits = optimum.digits,
                          .level = optimum.level,
                          .alternation = optimum.alternation,
                          .why = optimum.why};
        if (optimum.status == Status::converged)
          solution.rms_error = rms_of(any, narrowed, solution.parameters);
        return solution;
      },
      any);
}

}  // namespace shadefit
