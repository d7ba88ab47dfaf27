#include "fit/least_squares/least_squares.hpp"

#include <stdexcept>

#include "fit/least_squares/newton.hpp"

namespace shadefit {
namespace {

using WideVector = ParameterVector<long double>;

/// Whether a small step is also small by the part of the Hessian of Gauss and Newton. The Hessian was
/// corrected by gradients on the way. If these are mere rounding, as along the offset of `sg-scaled` at
/// exponent 1e9, it can take any value. Near an optimum with a small error both Hessians nearly agree: by the
/// second too the step must be below the promised 1e-14.
bool is_contradicted(const Sums<long double>& at, const WideVector& p) {
  if (p.size() == 1) return false;
  const WideVector step = newton_step(at.gradient, ParameterMatrix<double>(at.hessian.cast<double>()));
  return !step.allFinite() || relative_size(step, p) > 5 * settled;
}

/// Computes one more step by a rule, in long double, at the returned parameters, which are rounded to double.
/// If the step is negligible, the answer has settled. Else the result is true: another rule must be tried.
/// The step of a rule that is larger than the answer's own is taken; a smaller rule adds nothing.
bool settle(Optimum& optimum, const Candidate& candidate, const LeastSquaresProblem& problem,
            const Sampling& sampling, std::size_t rule) {
  WideVector p(candidate.parameters.size());
  std::copy(optimum.parameters.begin(), optimum.parameters.end(), p.begin());
  const Sums<long double> at = problem.wide(rule, values_of(p));
  const WideVector step = newton_step(at.gradient, *candidate.hessian);
  if (!step.allFinite()) {
    optimum.status = Status::not_finite;
    optimum.why = "a Newton step in long double is not finite";
    return false;
  }
  const long double size = relative_size(step, p);
  optimum.digits = correct_digits(size);
  optimum.rms_error = static_cast<double>(std::sqrt(at.square));
  if (size <= settled && !is_contradicted(at, p)) {
    optimum.status = Status::converged;
    optimum.why = {};
    return false;
  }
  if (rule == sampling.first) return true;
  for (std::size_t j = 0; j < optimum.parameters.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    optimum.parameters[j] = static_cast<double>(p[row] + step[row]);
  }
  ++optimum.iterations;
  return true;
}

Starts free_starts(const GivenParameters& given, const Starts& all) {
  Starts starts;
  for (std::size_t i = 0; i < starts.size(); ++i) starts[i] = free_ones(given, all[i]);
  return starts;
}

Optimum solve_free(const LeastSquaresProblem& problem, const Sampling& sampling, const Starts& starts) {
  Candidate candidate = common_optimum(starts, problem.basin);
  // A step below 2e-16 hardly changes a double.
  if (candidate.status == Status::converged) polish(problem.fine, candidate, 2e-16);
  Optimum optimum{.parameters = {candidate.parameters.begin(), candidate.parameters.end()},
                  .status = candidate.status,
                  .iterations = candidate.iterations,
                  .why = candidate.why};
  if (candidate.status != Status::converged) return optimum;
  optimum.status = Status::not_converged;
  optimum.why = "the largest quadrature rule still moves a parameter by more than 2e-15 of itself";
  // The rule below the one of the polish is the cheapest that can settle the answer, and nearly always does.
  // Larger rules are sampled only when they are needed.
  bool goes_on = settle(optimum, candidate, problem, sampling, sampling.first);
  for (std::size_t rule = sampling.first + 2; goes_on && rule < fit_rules.size(); ++rule)
    goes_on = settle(optimum, candidate, problem, sampling, rule);
  return optimum;
}

}  // namespace

Sampling::Sampling(const Metric& metric_asked, const Shape& shape_of_family,
                   std::span<const std::string_view> parameters)
    : metric(metric_asked), scale(metric), given(given_parameters(parameters, metric.constraints)) {
  Shape shape = shape_under(scale, shape_of_family);
  panels = Substitution::panels(metric, shape);
  first = first_rule(metric, shape);
  shape.concentration *= 2;
  shape.edges.clear();
  basin_panels = Substitution::panels(metric, shape);
  basin_rule = basin_nodes / static_cast<unsigned>(basin_panels.size());
}

GivenParameters given_parameters(std::span<const std::string_view> names, const Constraints& constraints) {
  GivenParameters given(names.size());
  for (const Held& held : constraints.held) {
    const auto found = std::find(names.begin(), names.end(), held.parameter);
    if (found == names.end()) throw std::logic_error("a held parameter that its family lacks");
    given[static_cast<std::size_t>(found - names.begin())] = held.value;
  }
  if (free_count(given) == 0) throw std::logic_error("no parameter is left free");
  return given;
}

Optimum solve_least_squares(const LeastSquaresProblem& problem, const Sampling& sampling,
                            const Starts& starts) {
  const GivenParameters& given = sampling.given;
  Optimum optimum = solve_free(of_free(problem, given), sampling, free_starts(given, starts));
  optimum.parameters = with_given<double>(given, optimum.parameters);
  optimum.rms_error /= scale_of(sampling.scale.weight, sampling.metric);
  return optimum;
}

Candidate start_of_minimax(const SampledErrors& basin, const Sampling& sampling, const Starts& all) {
  const Starts starts = free_starts(sampling.given, all);
  Candidate found = common_optimum(starts, of_free(basin, sampling.given), 1);
  // At the border of the admissible parameters the error has a pole, and no step leads back from there.
  if (found.status == Status::at_border) found.parameters = starts[0];
  return found;
}

double rms_of(const Sampling& sampling, const std::function<double(unsigned)>& square_by) {
  double last = -1, rms = -1;
  for (std::size_t i = sampling.first; i < fit_rules.size(); ++i) {
    rms = std::sqrt(square_by(fit_rules[i]));
    if (std::abs(rms - last) <= 1e-12 * rms) break;
    last = rms;
  }
  return rms / scale_of(sampling.scale.weight, sampling.metric);
}

}  // namespace shadefit
