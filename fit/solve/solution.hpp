#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fit/errors/extremum.hpp"
#include "fit/least_squares/first_parameters.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/status.hpp"
#include "fit/minimax/minimax_problem.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/rule_choice.hpp"
#include "fit/solve/under.hpp"

/// A family solved under any metric: the choice of the solver and of the free parameters.
namespace shadefit {

/// The result of a solver, with all parameters of the family in its order.
struct Solution {
  std::vector<double> parameters;
  Status status = Status::not_converged;
  int iterations = 0;
  int digits = 0;
  double rms_error = 0;  ///< sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2)
  std::optional<double> level = std::nullopt;
  std::vector<AlternationPoint> alternation = {};
  std::string why = {};
};

/// The given parameters of a metric by their places. Throws std::logic_error for a name that the family
/// lacks, and if no parameter is free.
template <class F>
GivenParameters<F::parameters.size()> given_parameters(const Constraints& constraints) {
  GivenParameters<F::parameters.size()> given{};
  for (const Held& held : constraints.held) {
    const auto found = std::find(F::parameters.begin(), F::parameters.end(), held.parameter);
    if (found == F::parameters.end()) throw std::logic_error("a held parameter that its family lacks");
    given[static_cast<std::size_t>(found - F::parameters.begin())] = held.value;
  }
  if (std::all_of(given.begin(), given.end(), [](const auto& g) { return g.has_value(); }))
    throw std::logic_error("no parameter is left free");
  return given;
}

/// sqrt(integral of measure * error^2 / integral of measure) at given parameters, with the weighted error: by
/// the first two rules that agree to 1e-12, else by the largest.
template <class F>
double scaled_rms_of(const F& family, const Metric& metric,
                     const std::array<double, F::parameters.size()>& p) {
  const auto panels = Substitution::panels(metric, family.shape());
  double last = -1;
  for (std::size_t i = first_rule(metric, family.shape()); i < fit_rules.size(); ++i) {
    const double rms = std::sqrt(SampledProblem<F, double>(family, panels, fit_rules[i]).square(p));
    if (std::abs(rms - last) <= 1e-12 * rms) return rms;
    last = rms;
  }
  return last;
}

/// sqrt(integral of measure * weight^2 / integral of measure): the scale of a weight.
inline double scale_of(const Weight& weight, const Metric& metric) {
  return weight.is_one() ? 1 : scaled_rms_of(WeightItself{weight}, metric, {});
}

/// sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2) at given parameters: a
/// weighted mean of the error, never above the largest error.
template <class F>
double rms_of(const Under<F>& family, const Metric& metric, const std::array<double, Under<F>::all>& p) {
  return scaled_rms_of(family, metric, p) / scale_of(family.weight, metric);
}

/// The quantity that a metric minimises over the places between `top` and `bottom`, at given parameters.
template <class F>
double objective_at(const F& family, const Metric& metric, const Cosine<double>& top,
                    const Cosine<double>& bottom, const std::array<double, F::parameters.size()>& p) {
  constexpr std::size_t N = F::parameters.size();
  const Under<F> under{family, metric.error, Weight(metric.weight, {bottom.cos_theta, top.cos_theta}), {}};
  Metric narrowed = metric;
  narrowed.domain = {bottom.cos_theta, top.cos_theta};
  if (metric.norm == Norm::least_squares) return rms_of(under, narrowed, p);
  const auto error = [&]<class T>(const Cosine<T>& c) {
    std::array<T, N> q;
    for (std::size_t i = 0; i < N; ++i) q[i] = lift<T>(p[i]);
    return under.error(under.sample(c), q);
  };
  const Shape shape = under.shape().for_search();
  return metric.error == Error::relative
             ? largest_magnitude(error, Substitution::between(top, bottom, shape)).magnitude
             : largest_magnitude(error, Substitution::panels({.domain = narrowed.domain}, shape)).magnitude;
}

/// A family between two places.
template <class F>
Solution solve_between(const Under<F>& family, const Metric& metric, const Cosine<double>& top,
                       const Cosine<double>& bottom) {
  Metric narrowed = metric;
  narrowed.domain = {bottom.cos_theta, top.cos_theta};
  const auto all = [&](const auto& free) {
    std::array<double, Under<F>::all> p;
    std::copy_n(free.begin(), p.size(), p.begin());
    const auto q = family.with_given(p);
    return std::vector<double>(q.begin(), q.end());
  };
  if (metric.norm == Norm::least_squares) {
    const LeastSquares<Under<F>> sampled(family, narrowed);
    const auto optimum = solve_first(sampled.problem(), family.starts(), family.free_count());
    return {.parameters = all(optimum.parameters),
            .status = optimum.status,
            .iterations = optimum.iterations,
            .digits = optimum.digits,
            .rms_error = optimum.rms_error / scale_of(family.weight, narrowed),
            .why = std::string(optimum.why)};
  }
  const MinimaxOptimum optimum = Minimax<Under<F>>(family, metric, top, bottom).solve();
  std::array<double, Under<F>::all> p;
  std::copy_n(optimum.parameters.begin(), p.size(), p.begin());
  const double rms = optimum.status == Status::converged ? rms_of(family, narrowed, p) : 0;
  return {all(p), optimum.status, optimum.iterations,  optimum.digits,
          rms,    optimum.level,  optimum.alternation, optimum.why};
}

}  // namespace shadefit
