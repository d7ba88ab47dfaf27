#pragma once

#include <ceres/tiny_solver.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "fit/gauss.hpp"
#include "fit/jet.hpp"
#include "fit/metric.hpp"
#include "fit/substitution.hpp"

/// Continuous least squares: minimise the integral of measure * error^2 over the parameters of a family.
///
/// Ceres finds the basin; it accepts steps by the cost, which is flat to the square root of the rounding, and
/// stalls at 8 to 12 digits. Newton on the gradient with the exact Hessian (Jets of Jets) finishes, in long
/// double at last and on ever larger quadrature rules, until a larger rule no longer moves the answer.
namespace shadefit {

static_assert(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits,
              "the digits of a fit are measured in an arithmetic wider than double");

enum class Status {
  converged,  ///< one optimum; in wider arithmetic the Newton step there is below `settled` of each parameter
  ambiguous,  ///< the three starts did not meet within `same_optimum` of each other
  not_converged,  ///< no quadrature rule settled the answer, or the gradient is not zero there
  not_finite,     ///< a value was infinite or not a number
};

constexpr std::string_view name(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::ambiguous:
      return "ambiguous";
    case Status::not_converged:
      return "not-converged";
    case Status::not_finite:
      return "not-finite";
  }
  return "unknown";
}

/// Relative. Polishing in double leaves a few units of 1e-16; two different optima differ visibly.
inline constexpr double same_optimum = 1e-12;
/// Relative. A parameter rounded to double is off by up to 1.1e-16; 1e-14 is promised, the next larger rule
/// adds more.
inline constexpr double settled = 2e-15;
/// The most that `digits` says: a claim of 15 digits would rest on the last bit of a double.
inline constexpr int most_digits = 14;

/// The optimum of a problem with N parameters.
template <int N>
struct Optimum {
  std::array<double, N> parameters{};
  Status status = Status::not_converged;
  int iterations = 0;    ///< Ceres and Newton steps of the start that was kept
  int digits = 0;        ///< floor(-log10 |Newton step / parameter|), the worst parameter, in long double
  double rms_error = 0;  ///< sqrt(integral of measure * error^2 / integral of measure)
};

/// A family sampled at the nodes of a Gauss rule: sums stand for the integrals over the measure, of total 1.
template <class F, class T>
class SampledProblem {
 public:
  static constexpr int N = static_cast<int>(F::parameters.size());
  using Vector = Eigen::Matrix<T, N, 1>;
  using Matrix = Eigen::Matrix<T, N, N>;

  struct Derivatives {
    T square = 0;  ///< integral of error^2
    Vector gradient = Vector::Zero();
    Matrix hessian = Matrix::Zero();
  };

  SampledProblem(const F& family, const Substitution& substitution, std::size_t rule) : family_(family) {
    for (const GaussNode<T>& node : gauss_nodes<T>(rule)) {
      const auto place = substitution.at(node.position);
      samples_.push_back(family.sample(place.cosine));
      weights_.push_back(node.weight * place.density / static_cast<T>(substitution.total()));
    }
  }

  std::size_t size() const { return samples_.size(); }
  T weight(std::size_t i) const { return weights_[i]; }

  template <class P>
  P error(std::size_t i, const std::array<P, N>& p) const {
    return family_.error(samples_[i], p);
  }

  /// Half the square's gradient and Hessian: sum of w r r_i and of w (r_i r_j + r r_ij).
  Derivatives derivatives(const std::array<T, N>& p) const {
    using First = ceres::Jet<T, N>;
    using Second = ceres::Jet<First, N>;
    std::array<Second, N> seeds;
    for (int i = 0; i < N; ++i) {
      seeds[static_cast<std::size_t>(i)] = Second(First(p[static_cast<std::size_t>(i)], i));
      seeds[static_cast<std::size_t>(i)].v[i] = First(T(1));
    }
    Derivatives d;
    for (std::size_t node = 0; node < samples_.size(); ++node) {
      const Second r = error(node, seeds);
      const T w = weights_[node];
      d.square += w * r.a.a * r.a.a;
      for (int i = 0; i < N; ++i) {
        d.gradient[i] += w * r.a.a * r.a.v[i];
        for (int j = 0; j < N; ++j) d.hessian(i, j) += w * (r.a.v[i] * r.a.v[j] + r.a.a * r.v[i].v[j]);
      }
    }
    return d;
  }

 private:
  F family_;
  std::vector<typename F::template Sample<T>> samples_;
  std::vector<T> weights_;
};

/// The Newton step -H^-1 g; `is_minimum` says whether H is positive definite (its leading minors, by
/// Sylvester).
template <class T, int N>
struct NewtonStep {
  std::array<T, N> step;
  bool is_minimum;
  bool is_finite;
};

template <class Problem, class T, std::size_t N>
NewtonStep<T, static_cast<int>(N)> newton_step(const Problem& problem, const std::array<T, N>& p) {
  const auto d = problem.derivatives(p);
  const typename Problem::Vector step = -d.hessian.inverse() * d.gradient;
  NewtonStep<T, static_cast<int>(N)> result{{}, true, true};
  for (int i = 0; i < static_cast<int>(N); ++i) {
    result.step[static_cast<std::size_t>(i)] = step[i];
    result.is_finite = result.is_finite && std::isfinite(step[i]);
    result.is_minimum = result.is_minimum && d.hessian.topLeftCorner(i + 1, i + 1).determinant() > 0;
  }
  return result;
}

/// The largest |step / parameter|. A parameter whose optimum is 0 has no relative digits and never settles.
template <class T, std::size_t N>
T relative_size(const std::array<T, N>& step, const std::array<T, N>& p) {
  T largest = 0;
  for (std::size_t i = 0; i < N; ++i) {
    if (step[i] != 0) largest = std::max(largest, std::abs(step[i] / p[i]));
  }
  return largest;
}

/// The digits that a relative Newton step leaves: floor(-log10), from 0 to `most_digits`.
inline int correct_digits(long double relative_step) {
  if (std::isnan(relative_step)) return 0;
  const long double digits = std::floor(-std::log10(relative_step));  // infinite for a step of 0
  return static_cast<int>(std::clamp(digits, 0.0L, static_cast<long double>(most_digits)));
}

namespace detail {

/// What ceres::TinySolver minimises: sqrt(weight) * error, scaled to norm 1 at the start. TinySolver stops at
/// absolute changes of the cost, and the cost of a lobe of exponent 1e6 is 1e-19 from the beginning.
template <class F>
struct TinyFunction {
  using Scalar = double;
  static constexpr int N = SampledProblem<F, double>::N;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = N };

  const SampledProblem<F, double>& problem;
  double scale;

  int NumResiduals() const { return static_cast<int>(problem.size()); }

  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    using Jet = ceres::Jet<double, N>;
    std::array<Jet, N> p;
    for (int i = 0; i < N; ++i) p[static_cast<std::size_t>(i)] = Jet(parameters[i], i);
    for (std::size_t node = 0; node < problem.size(); ++node) {
      const double weight = scale * std::sqrt(problem.weight(node));
      const Jet r = problem.error(node, p);
      residuals[node] = weight * r.a;
      if (jacobian == nullptr) continue;
      for (std::size_t i = 0; i < N; ++i)
        jacobian[i * problem.size() + node] = weight * r.v[static_cast<int>(i)];
    }
    return true;
  }
};

template <int N>
struct Candidate {
  std::array<double, N> parameters;
  int iterations = 0;
  Status status = Status::not_converged;
};

/// Ceres into the basin, Newton in double to its bottom.
template <class F>
auto descend(const SampledProblem<F, double>& problem, const auto& start) {
  constexpr int N = SampledProblem<F, double>::N;
  Candidate<N> candidate{start};
  const double square = problem.derivatives(start).square;
  if (!std::isfinite(square)) candidate.status = Status::not_finite;
  if (!(square > 0) || !std::isfinite(square)) return candidate;  // a square of 0 has underflowed

  const TinyFunction<F> function{problem, 1 / std::sqrt(square)};
  ceres::TinySolver<TinyFunction<F>> solver;
  // Only the basin is wanted: a step of 1e-6 (|x| + 1e-6) is well inside Newton's; cost tests are off.
  solver.options.parameter_tolerance = 1e-6;
  solver.options.function_tolerance = 0;
  solver.options.gradient_tolerance = 0;
  solver.options.cost_threshold = 0;
  typename ceres::TinySolver<TinyFunction<F>>::Parameters parameters;
  for (int i = 0; i < N; ++i) parameters[i] = start[static_cast<std::size_t>(i)];
  candidate.iterations = solver.Solve(function, &parameters).iterations;
  for (int i = 0; i < N; ++i) candidate.parameters[static_cast<std::size_t>(i)] = parameters[i];

  // Quadratic convergence from 1e-6 takes two steps; twenty leave room for a start that Ceres gave up on.
  for (int i = 0; i < 20; ++i) {
    const auto newton = newton_step(problem, candidate.parameters);
    if (!newton.is_finite) {
      candidate.status = Status::not_finite;
      return candidate;
    }
    for (std::size_t j = 0; j < N; ++j) candidate.parameters[j] += newton.step[j];
    ++candidate.iterations;
    // Steps below 1e-13 are the rounding of the sums, not progress.
    if (relative_size(newton.step, candidate.parameters) < 1e-13) {
      if (newton.is_minimum) candidate.status = Status::converged;
      return candidate;
    }
  }
  return candidate;
}

}  // namespace detail

namespace detail {

/// The optimum on the smallest rule, if all three starts lead to it; else the status says why not.
template <class F>
auto common_optimum(const F& family, const Substitution& substitution) {
  const SampledProblem<F, double> problem(family, substitution, 0);
  const auto starts = family.starts();
  const auto first = descend(problem, starts[0]);
  auto common = first;
  for (const auto& start : {starts[1], starts[2]}) {
    const auto candidate = descend(problem, start);
    auto gap = candidate.parameters;
    for (std::size_t j = 0; j < gap.size(); ++j) gap[j] -= first.parameters[j];
    if (candidate.status != Status::converged) {
      common.status = candidate.status;
    } else if (relative_size(gap, first.parameters) > same_optimum && common.status == Status::converged) {
      common.status = Status::ambiguous;
    }
  }
  return common;
}

/// Climbs the rules from the second on, one Newton step in long double on each, until a larger rule asks for
/// no further step at the parameters as they are returned, rounded to double.
template <class F>
void climb(const F& family, const Substitution& substitution, auto& optimum) {
  constexpr int N = SampledProblem<F, double>::N;
  for (std::size_t rule = 1; rule < gauss_sizes.size(); ++rule) {
    const SampledProblem<F, long double> problem(family, substitution, rule);
    std::array<long double, N> p;
    std::copy(optimum.parameters.begin(), optimum.parameters.end(), p.begin());
    const auto newton = newton_step(problem, p);
    if (!newton.is_finite) {
      optimum.status = Status::not_finite;
      return;
    }
    const long double size = relative_size(newton.step, p);
    optimum.digits = correct_digits(size);
    optimum.rms_error = static_cast<double>(std::sqrt(problem.derivatives(p).square));
    if (newton.is_minimum && size <= settled) {
      optimum.status = Status::converged;
      return;
    }
    for (std::size_t j = 0; j < N; ++j) optimum.parameters[j] = static_cast<double>(p[j] + newton.step[j]);
    ++optimum.iterations;
  }
}

}  // namespace detail

/// Fits a family under a metric (norm: least squares). Never throws for a hard problem: the status says how
/// it went, and parameters are an answer only where it is `converged`.
template <class F>
auto solve_least_squares(const F& family, const Metric& metric) {
  const Substitution substitution(metric, family.shape());
  const auto common = detail::common_optimum(family, substitution);
  Optimum<SampledProblem<F, double>::N> optimum{.parameters = common.parameters,
                                                .iterations = common.iterations};
  if (common.status == Status::converged) {
    detail::climb(family, substitution, optimum);
  } else {
    optimum.status = common.status;
  }
  return optimum;
}

}  // namespace shadefit
