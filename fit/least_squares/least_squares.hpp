#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "fit/families/admissible.hpp"
#include "fit/least_squares/descent.hpp"
#include "fit/least_squares/digits.hpp"
#include "fit/least_squares/error_scale.hpp"
#include "fit/least_squares/sampled_errors.hpp"
#include "fit/least_squares/sampled_problem.hpp"
#include "fit/least_squares/status.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/quadrature/rule_choice.hpp"
#include "fit/quadrature/substitution.hpp"

/// Continuous least squares: minimise the integral of measure * error^2 over the parameters of a family.
///
/// Ceres finds the basin, on few nodes. It accepts steps by the cost. Near the optimum the cost is flat to
/// the square root of the rounding, so Ceres stalls at 8 to 12 digits. Newton on the gradient, with the exact
/// Hessian (Jets of Jets), finishes on a larger rule. Then a rule of another size computes one more step in
/// long double. That step must be negligible: its size gives the digits of the fit.
namespace shadefit {

struct Optimum {
  std::vector<double> parameters;  ///< all of the family, in its order
  Status status = Status::not_converged;
  int iterations = 0;    ///< Ceres and Newton steps of the start that was kept
  int digits = 0;        ///< floor(-log10 |Newton step / parameter|), the worst parameter, in long double
  double rms_error = 0;  ///< sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2)
  std::string_view why = {};  ///< where it did not converge, in words
};

/// How a family is sampled under a metric.
struct Sampling {
  Sampling(const Metric& metric, const Shape& shape_of_family, std::span<const std::string_view> parameters);

  Metric metric;
  ErrorScale scale;
  GivenParameters given;
  std::vector<Substitution> panels;
  std::size_t first;  ///< of `fit_rules`: the check's; the polish has the next
  /// For the basin, a concentrated integrand is cut at half the decay. That loses 4e-11, less than twelve
  /// nodes over the whole of it would. The edges of a weight are left to the polish.
  std::vector<Substitution> basin_panels;
  unsigned basin_rule;
};

/// The given parameters of a metric by their places. Throws std::logic_error for a name that the family
/// lacks, and if no parameter is free.
GivenParameters given_parameters(std::span<const std::string_view> names, const Constraints& constraints);

/// The optimum over the free parameters, from three starts with all. Never throws for a hard problem. The
/// status says how it ended; the parameters are an answer only if it is `converged`.
Optimum solve_least_squares(const LeastSquaresProblem& problem, const Sampling& sampling,
                            const Starts& starts);

/// A start for minimax: the free parameters that Ceres finds from the first start under the same error,
/// polished on few nodes.
Candidate start_of_minimax(const SampledErrors& basin, const Sampling& sampling, const Starts& starts);

/// sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2): a weighted mean of the
/// error, never above the largest error. `square_by` sums by a rule; the first two rules count that agree to
/// 1e-12, else the largest.
double rms_of(const Sampling& sampling, const std::function<double(unsigned rule)>& square_by);

/// The starts of a family.
template <class F>
Starts starts_of_family(const F& family) {
  const auto of_family = family.starts();
  Starts starts;
  for (std::size_t i = 0; i < starts.size(); ++i) starts[i] = vector_of(of_family[i]);
  return starts;
}

/// A sampled family and the family behind plain functions. They refer to both: neither may move while they
/// are in use.
template <class F>
SampledErrors sampled_errors(const SampledProblem<F, double>& sampled, const F& family,
                             const Domain& domain) {
  using Problem = SampledProblem<F, double>;
  using Parameters = std::span<const double>;
  const auto* problem = &sampled;
  return {.square = [problem](Parameters p) { return problem->square(Problem::array_of(p)); },
          .gradient = [problem](Parameters p) { return problem->gradient(Problem::array_of(p)); },
          .derivatives = [problem](Parameters p) { return problem->derivatives(Problem::array_of(p)); },
          .errors = [problem](Parameters p, std::span<double> r,
                              std::span<double> slopes) { problem->errors(Problem::array_of(p), r, slopes); },
          .weight = [problem](std::size_t node) { return problem->weight(node); },
          .is_admissible =
              [asked = &family, domain](Parameters p) {
                return shadefit::is_admissible(*asked, domain, Problem::array_of(p));
              }};
}

/// A family at the nodes where Ceres looks for the basin.
template <class F>
SampledProblem<F, double> basin_of(const F& family, const Sampling& sampling) {
  return {family, sampling.basin_panels, sampling.basin_rule, sampling.scale};
}

/// A family under a metric (norm: least squares), sampled and ready to be solved.
template <class F>
class LeastSquares {
 public:
  static_assert(F::parameters.size() < basin_nodes, "the nodes of the basin determine fewer parameters");

  LeastSquares(const F& family, const Metric& metric)
      : family_(family),
        sampling_(metric, family.shape(), F::parameters),
        basin_(basin_of(family, sampling_)),
        fine_(sampled<double>(sampling_.first + 1)),
        wide_(sampled<long double>(sampling_.first)) {}

  Optimum solve() const { return solve(starts_of_family(family_)); }

  /// The same from given starts.
  Optimum solve(const Starts& starts) const { return solve_least_squares(problem(), sampling_, starts); }

 private:
  /// By a rule, an index of `fit_rules`.
  template <class T>
  SampledProblem<F, T> sampled(std::size_t rule) const {
    return {family_, sampling_.panels, fit_rules[rule], sampling_.scale};
  }

  LeastSquaresProblem problem() const {
    const auto wide = [this](std::size_t rule, std::span<const long double> values) {
      const auto p = SampledProblem<F, long double>::array_of(values);
      return rule == sampling_.first ? wide_.gradient(p) : sampled<long double>(rule).gradient(p);
    };
    const Domain& domain = sampling_.metric.domain;
    return {sampled_errors(basin_, family_, domain), sampled_errors(fine_, family_, domain), wide};
  }

  F family_;
  Sampling sampling_;
  SampledProblem<F, double> basin_, fine_;
  SampledProblem<F, long double> wide_;
};

/// Fits a family under a metric.
template <class F>
Optimum solve_least_squares(const F& family, const Metric& metric) {
  return LeastSquares<F>(family, metric).solve();
}

/// The start of minimax for a family.
template <class F>
Candidate start_of_minimax(const F& family, const Metric& metric) {
  const Sampling sampling(metric, family.shape(), F::parameters);
  const auto basin = basin_of(family, sampling);
  return start_of_minimax(sampled_errors(basin, family, metric.domain), sampling, starts_of_family(family));
}

/// The sums of a family at given parameters, by 38 nodes on each panel.
template <class F>
Sums<double> sums_of(const F& family, const Metric& metric, std::span<const double> parameters) {
  const Sampling sampling(metric, family.shape(), F::parameters);
  const SampledProblem<F, double> sampled(family, sampling.panels, 38, sampling.scale);
  return sampled.derivatives(sampled.array_of(parameters));
}

/// The root mean square of a family's error at given parameters.
template <class F>
double rms_of(const F& family, const Metric& metric, std::span<const double> parameters) {
  const Sampling sampling(metric, family.shape(), F::parameters);
  return rms_of(sampling, [&](unsigned rule) {
    const SampledProblem<F, double> sampled(family, sampling.panels, rule, sampling.scale);
    return sampled.square(sampled.array_of(parameters));
  });
}

}  // namespace shadefit
