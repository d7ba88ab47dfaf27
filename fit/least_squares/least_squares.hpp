#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "fit/least_squares/descent.hpp"
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

static_assert(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits,
              "the digits of a fit are measured in an arithmetic wider than double");

/// Relative. Rounding a parameter to double costs up to 1.1e-16. 1e-14 is promised, and the next larger rule
/// gives more.
inline constexpr double settled = 2e-15;
/// The most digits that are claimed: 15 would rest on the last bit of a double.
inline constexpr int most_digits = 14;

/// The optimum of a problem with N parameters.
template <int N>
struct Optimum {
  std::array<double, N> parameters{};
  Status status = Status::not_converged;
  int iterations = 0;    ///< Ceres and Newton steps of the start that was kept
  int digits = 0;        ///< floor(-log10 |Newton step / parameter|), the worst parameter, in long double
  double rms_error = 0;  ///< sqrt(integral of measure * error^2 / integral of measure); a weight of the error
                         ///< scales it too (`scale_of` in fit/solve/solution.hpp)
  std::string_view why = {};  ///< where it did not converge, in words
};

/// The digits that a relative Newton step leaves: floor(-log10), from 0 to `most_digits`.
inline int correct_digits(long double relative_step) {
  if (std::isnan(relative_step)) return 0;
  const long double digits = std::floor(-std::log10(relative_step));  // infinite for a step of 0
  return static_cast<int>(std::clamp(digits, 0.0L, static_cast<long double>(most_digits)));
}

/// A problem under each rule that its solver uses, behind plain functions.
template <int N>
struct LeastSquaresProblem {
  DescentProblem<N> basin, fine;
  /// The gradient in long double by a rule, an index of `fit_rules`.
  std::function<SampledGradient<long double, N>(std::size_t, const std::array<long double, N>&)> wide;
  std::size_t first;  ///< of `fit_rules`: the check's; `fine` has the next
};

/// Whether a small step is also small by the part of the Hessian of Gauss and Newton. The Hessian was
/// corrected by gradients on the way. If these are mere rounding, as along the offset of `sg-scaled` at
/// exponent 1e9, it can take any value. Near an optimum with a small error both Hessians nearly agree: by the
/// second too the step must be below the promised 1e-14.
template <int N>
bool is_contradicted(const SampledGradient<long double, N>& at, const std::array<long double, N>& p) {
  if constexpr (N == 1) {
    return false;
  } else {
    const Eigen::Matrix<double, N, N> lower = at.slopes.template cast<double>();
    const Eigen::Matrix<double, N, N> slopes = lower.template selfadjointView<Eigen::Lower>();
    const auto step = newton_step<long double, double, N>(at.gradient, slopes);
    return !step.is_finite || relative_size(step.step, p) > 5 * settled;
  }
}

/// Computes one more step by a rule, in long double, at the returned parameters, which are rounded to double.
/// If the step is negligible, the answer has settled. Else the result is true: another rule must be tried.
/// The step of a rule that is larger than the answer's own is taken; a smaller rule adds nothing.
template <int N>
bool settle(Optimum<N>& optimum, const Candidate<N>& candidate, const LeastSquaresProblem<N>& problem,
            std::size_t rule) {
  std::array<long double, N> p;
  std::copy(optimum.parameters.begin(), optimum.parameters.end(), p.begin());
  const auto at = problem.wide(rule, p);
  const auto newton = newton_step<long double, double, N>(at.gradient, *candidate.hessian);
  if (!newton.is_finite) {
    optimum.status = Status::not_finite;
    optimum.why = "a Newton step in long double is not finite";
    return false;
  }
  const long double size = relative_size(newton.step, p);
  optimum.digits = correct_digits(size);
  optimum.rms_error = static_cast<double>(std::sqrt(at.square));
  if (size <= settled && !is_contradicted<N>(at, p)) {
    optimum.status = Status::converged;
    optimum.why = {};
    return false;
  }
  if (rule == problem.first) return true;
  for (std::size_t j = 0; j < p.size(); ++j)
    optimum.parameters[j] = static_cast<double>(p[j] + newton.step[j]);
  ++optimum.iterations;
  return true;
}

/// Never throws for a hard problem. The status says how it ended; the parameters are an answer only if it is
/// `converged`.
template <int N>
Optimum<N> solve_least_squares(const LeastSquaresProblem<N>& problem, const Starts<N>& starts) {
  auto candidate = common_optimum<N>(starts, problem.basin);
  // A step below 2e-16 hardly changes a double.
  if (candidate.status == Status::converged) polish<N>(problem.fine, candidate, 2e-16);
  Optimum<N> optimum{.parameters = candidate.parameters,
                     .status = candidate.status,
                     .iterations = candidate.iterations,
                     .why = candidate.why};
  if (candidate.status != Status::converged) return optimum;
  optimum.status = Status::not_converged;
  optimum.why = "the largest quadrature rule still moves a parameter by more than 2e-15 of itself";
  // The rule below the one of the polish is the cheapest that can settle the answer, and nearly always does.
  // Larger rules are sampled only when they are needed.
  bool goes_on = settle<N>(optimum, candidate, problem, problem.first);
  for (std::size_t rule = problem.first + 2; goes_on && rule < fit_rules.size(); ++rule)
    goes_on = settle<N>(optimum, candidate, problem, rule);
  return optimum;
}

/// A family under a metric (norm: least squares), sampled and ready to be solved.
template <class F>
class LeastSquares {
 public:
  static constexpr int N = SampledProblem<F, double>::N;

  LeastSquares(const F& family, const Metric& metric)
      : family_(family),
        domain_(metric.domain),
        panels_(Substitution::panels(metric, family.shape())),
        first_(first_rule(metric, family.shape())),
        basin_(sampled_for_basin(family, metric, blunt(family.shape()))),
        fine_(family, panels_, fit_rules[first_ + 1]),
        wide_(family, panels_, fit_rules[first_]) {}

  Optimum<N> solve() const { return solve(family_.starts()); }

  /// The same from given starts.
  Optimum<N> solve(const Starts<N>& starts) const { return solve_least_squares<N>(problem(), starts); }

  /// This must not move while its problem is in use.
  LeastSquaresProblem<N> problem() const {
    const auto wide = [this](std::size_t rule, const std::array<long double, N>& p) {
      if (rule == first_) return wide_.gradient(p);
      return SampledProblem<F, long double>(family_, panels_, fit_rules[rule]).gradient(p);
    };
    return {descent_problem(basin_, family_, domain_), descent_problem(fine_, family_, domain_), wide,
            first_};
  }

 private:
  /// For the basin, a concentrated integrand is cut at half the decay. That loses 4e-11, less than twelve
  /// nodes over the whole of it would.
  static Shape blunt(Shape shape) {
    shape.concentration *= 2;
    return shape;
  }

  F family_;
  Domain domain_;
  std::vector<Substitution> panels_;
  std::size_t first_;  ///< of `fit_rules`: the check's; the polish has the next
  SampledProblem<F, double> basin_, fine_;
  SampledProblem<F, long double> wide_;
};

/// Fits a family under a metric.
template <class F>
auto solve_least_squares(const F& family, const Metric& metric) {
  return LeastSquares<F>(family, metric).solve();
}

// The families of this library have one to four parameters: for these the solver is compiled in
// fit/least_squares/least_squares.cpp.
extern template Optimum<1> solve_least_squares(const LeastSquaresProblem<1>&, const Starts<1>&);
extern template Optimum<2> solve_least_squares(const LeastSquaresProblem<2>&, const Starts<2>&);
extern template Optimum<3> solve_least_squares(const LeastSquaresProblem<3>&, const Starts<3>&);
extern template Optimum<4> solve_least_squares(const LeastSquaresProblem<4>&, const Starts<4>&);
extern template Candidate<1> common_optimum(const Starts<1>&, const DescentProblem<1>&, std::size_t);
extern template Candidate<2> common_optimum(const Starts<2>&, const DescentProblem<2>&, std::size_t);
extern template Candidate<3> common_optimum(const Starts<3>&, const DescentProblem<3>&, std::size_t);
extern template Candidate<4> common_optimum(const Starts<4>&, const DescentProblem<4>&, std::size_t);

}  // namespace shadefit
