#include <variant>

#include "fit/least_squares/least_squares.hpp"
#include "fit/solve.hpp"

namespace shadefit {
namespace {

Solution solution_of(const Optimum& optimum) {
  return {.parameters = optimum.parameters,
          .status = optimum.status,
          .iterations = optimum.iterations,
          .digits = optimum.digits,
          .rms_error = optimum.rms_error,
          .why = std::string(optimum.why)};
}

}  // namespace

Solution solve_by_squares(const AnyFamily& any, const Metric& metric) {
  return std::visit(
      [&](const auto& family) { return solve_by_squares(any, metric, starts_of_family(family)); }, any);
}

Solution solve_by_squares(const AnyFamily& any, const Metric& metric, const Starts& starts) {
  return std::visit(
      [&]<class F>(const F& family) { return solution_of(LeastSquares<F>(family, metric).solve(starts)); },
      any);
}

Candidate start_of_minimax(const AnyFamily& any, const Metric& metric) {
  return std::visit([&](const auto& family) { return start_of_minimax(family, metric); }, any);
}

Sums<double> sums_of(const AnyFamily& any, const Metric& metric, std::span<const double> parameters) {
  return std::visit([&](const auto& family) { return sums_of(family, metric, parameters); }, any);
}

double rms_of(const AnyFamily& any, const Metric& metric, std::span<const double> parameters) {
  return std::visit([&](const auto& family) { return rms_of(family, metric, parameters); }, any);
}

}  // namespace shadefit
