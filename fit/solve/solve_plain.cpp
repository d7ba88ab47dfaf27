#include <algorithm>
#include <cstddef>
#include <variant>

#include "fit/least_squares/least_squares.hpp"
#include "fit/solve/solve.hpp"

namespace shadefit {
namespace {

template <int N>
Solution solution_of(const Optimum<N>& optimum) {
  return {.parameters = {optimum.parameters.begin(), optimum.parameters.end()},
          .status = optimum.status,
          .iterations = optimum.iterations,
          .digits = optimum.digits,
          .rms_error = optimum.rms_error,
          .why = std::string(optimum.why)};
}

}  // namespace

Solution solve_plain(const AnyFamily& any, const Metric& metric) {
  return std::visit([&](const auto& family) { return solution_of(solve_least_squares(family, metric)); },
                    any);
}

Solution solve_plain_from(const AnyFamily& any, const Metric& metric,
                          const std::array<std::vector<double>, 3>& starts) {
  return std::visit(
      [&]<class F>(const F& family) {
        Starts<static_cast<int>(F::parameters.size())> points;
        for (std::size_t i = 0; i < points.size(); ++i)
          std::copy_n(starts[i].begin(), points[i].size(), points[i].begin());
        return solution_of(LeastSquares<F>(family, metric).solve(points));
      },
      any);
}

}  // namespace shadefit
