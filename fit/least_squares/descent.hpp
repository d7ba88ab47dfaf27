#pragma once

#include <ceres/tiny_solver.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "fit/families/admissible.hpp"
#include "fit/least_squares/positive_definite.hpp"
#include "fit/least_squares/sampled_problem.hpp"
#include "fit/least_squares/status.hpp"
#include "fit/scalars/jet.hpp"

/// The way down to the optimum of a sampled problem: Ceres into the basin from three starts, Newton to its
/// bottom.
namespace shadefit {

/// Relative. Polishing in double leaves a few units of 1e-16; two different optima differ visibly. A looser
/// agreement saves no time that could be measured, and lets a pair on a thousandth of its domain pass with a
/// wrong optimum.
inline constexpr double same_optimum = 1e-12;
/// Ceres looks for the basin with twelve nodes, on one panel or two.
inline constexpr unsigned basin_nodes = 12;

/// A family at those nodes; the edges of a weight are left to the polish.
template <class F>
SampledProblem<F, double> sampled_for_basin(const F& family, const Metric& metric, Shape shape) {
  shape.edges.clear();
  const auto panels = Substitution::panels(metric, shape);
  return {family, panels, basin_nodes / static_cast<unsigned>(panels.size())};
}

/// The Newton step -H^-1 g.
template <class T, int N>
struct NewtonStep {
  std::array<T, static_cast<std::size_t>(N)> step{};
  bool is_finite = true;
};

/// The gradient may be in wider arithmetic than the Hessian, whose own rounding only shortens or lengthens a
/// step.
template <class T, class H, int N>
NewtonStep<T, N> newton_step(const Eigen::Matrix<T, N, 1>& gradient, const Eigen::Matrix<H, N, N>& hessian) {
  const Eigen::Matrix<H, N, N> inverse = hessian.inverse();
  NewtonStep<T, N> result;
  for (int i = 0; i < N; ++i) {
    T step = 0;
    for (int j = 0; j < N; ++j) step -= static_cast<T>(inverse(i, j)) * gradient[j];
    result.step[static_cast<std::size_t>(i)] = step;
    result.is_finite = result.is_finite && std::isfinite(step);
  }
  return result;
}

/// Whether a point with this Hessian is a minimum.
template <int N>
bool is_minimum(const Eigen::Matrix<double, N, N>& hessian) {
  std::array<double, N * N> rows;
  std::copy_n(hessian.data(), rows.size(), rows.begin());
  return is_positive_definite<N>(rows, [](double pivot) { return pivot > 0; });
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

/// A sampled problem behind plain functions, so that the descent is compiled once for all families with N
/// parameters.
template <int N>
struct DescentProblem {
  using Parameters = std::array<double, static_cast<std::size_t>(N)>;

  std::function<double(const Parameters&)> square;
  std::function<SampledGradient<double, N>(const Parameters&)> gradient;
  std::function<SampledDerivatives<double, N>(const Parameters&)> derivatives;
  std::function<void(const Parameters&, std::span<double>, std::span<double>)> errors;
  std::function<double(std::size_t)> weight;
  std::function<bool(const Parameters&)> is_admissible;  ///< at a start they are
};

/// The functions refer to the sampled problem and the family: neither may move while they are in use.
template <class F>
auto descent_problem(const SampledProblem<F, double>& sampled, const F& family, const Domain& domain) {
  constexpr int N = SampledProblem<F, double>::N;
  using Parameters = typename DescentProblem<N>::Parameters;
  const auto* problem = &sampled;
  return DescentProblem<N>{
      .square = [problem](const Parameters& p) { return problem->square(p); },
      .gradient = [problem](const Parameters& p) { return problem->gradient(p); },
      .derivatives = [problem](const Parameters& p) { return problem->derivatives(p); },
      .errors = [problem](const Parameters& p, std::span<double> r,
                          std::span<double> slopes) { problem->errors(p, r, slopes); },
      .weight = [problem](std::size_t node) { return problem->weight(node); },
      .is_admissible = [asked = &family,
                        domain](const Parameters& p) { return shadefit::is_admissible(*asked, domain, p); }};
}

/// What ceres::TinySolver minimises: sqrt(weight) * error, scaled to norm 1 at the start. TinySolver stops at
/// absolute changes of the cost, and the cost of a lobe of exponent 1e6 is 1e-19 from the beginning.
///
/// After a step it asks for the errors, and once it has accepted the step, for the errors and their
/// derivatives at the same place. Both are computed together, and the last result is kept.
template <int N>
class TinyFunction {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = static_cast<int>(basin_nodes), NUM_PARAMETERS = N };

  TinyFunction(const DescentProblem<N>& problem, double square) : problem_(problem) {
    for (std::size_t i = 0; i < basin_nodes; ++i) roots_[i] = std::sqrt(problem_.weight(i) / square);
  }

  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    if (!place_ || !std::equal(place_->begin(), place_->end(), parameters)) move_to(parameters);
    std::copy(residuals_.begin(), residuals_.end(), residuals);
    if (jacobian != nullptr) std::copy(jacobian_.begin(), jacobian_.end(), jacobian);
    return true;
  }

  /// Whether the last requested place is outside of the admissible parameters.
  bool is_turned_back() const { return is_turned_back_; }

 private:
  void move_to(const double* parameters) const {
    place_.emplace();
    std::copy_n(parameters, N, place_->begin());
    problem_.errors(*place_, residuals_, jacobian_);
    // An infinite cost rejects a step.
    is_turned_back_ = !problem_.is_admissible(*place_);
    if (is_turned_back_) residuals_.fill(HUGE_VAL);
    for (std::size_t node = 0; node < basin_nodes; ++node) {
      residuals_[node] *= roots_[node];
      for (std::size_t i = 0; i < N; ++i) jacobian_[i * basin_nodes + node] *= roots_[node];
    }
  }

  const DescentProblem<N>& problem_;
  std::array<double, basin_nodes> roots_{};  ///< of the weights, scaled
  mutable std::optional<typename DescentProblem<N>::Parameters> place_ = std::nullopt;
  mutable bool is_turned_back_ = false;
  mutable std::array<double, basin_nodes> residuals_{};
  mutable std::array<double, basin_nodes * N> jacobian_{};
};

/// A point on the way down, and a Hessian from nearby, if there is one.
template <int N>
struct Candidate {
  std::array<double, static_cast<std::size_t>(N)> parameters{};
  std::optional<Eigen::Matrix<double, N, N>> hessian = std::nullopt;
  int iterations = 0;
  Status status = Status::not_converged;
  std::string_view why = {};  ///< where it did not converge, in words
};

/// The largest relative distance of two points, measured in the second.
template <std::size_t N>
double distance(std::array<double, N> p, const std::array<double, N>& from) {
  for (std::size_t j = 0; j < N; ++j) p[j] -= from[j];
  return relative_size(p, from);
}

template <int N>
using TinySolver = ceres::TinySolver<TinyFunction<N>>;

/// How far Ceres goes before Newton takes over.
struct Patience {
  double last_step;  ///< it ends with a step below this, relative
  int most_steps;
};

/// Only the basin is needed: a step of 1e-2 (|x| + 1e-2) usually ends where Newton converges.
inline constexpr Patience hasty{1e-2, 50};
/// On a steep wall, steps are damped below 1e-2 far from any basin, and Newton's first step would leave it
/// for good. Steps of Levenberg and Marquardt always go down: twenty to forty of them reach a place that
/// Newton confirms.
inline constexpr Patience patient{1e-7, 400};

/// Cost tests are off.
template <int N>
TinySolver<N> basin_solver(const Patience& patience) {
  TinySolver<N> solver;
  solver.options.parameter_tolerance = patience.last_step;
  solver.options.max_num_iterations = patience.most_steps;
  solver.options.function_tolerance = 0;
  solver.options.gradient_tolerance = 0;
  solver.options.cost_threshold = 0;
  return solver;
}

/// Corrects a Hessian by the change of the gradient along a step (symmetric rank one; with one parameter: the
/// secant). A change that was expected corrects nothing. Source:
/// Nocedal, Wright 2006, "Numerical Optimization", 6.2.
template <int N>
void correct(Eigen::Matrix<double, N, N>& hessian, const Eigen::Matrix<double, N, 1>& step,
             const Eigen::Matrix<double, N, 1>& change) {
  const Eigen::Matrix<double, N, 1> surprise = change - hessian * step;
  const double along = surprise.dot(step);
  if (std::abs(along) > 1e-8 * surprise.norm() * step.norm())
    hessian += surprise * surprise.transpose() / along;
}

/// Takes a step, or the first of its half, quarter, .. that leaves the parameters admissible. False if the
/// step was cut. Takes nothing if the parameters are not admissible before the step.
template <int N>
bool take_step(const DescentProblem<N>& problem, typename DescentProblem<N>::Parameters& p,
               typename DescentProblem<N>::Parameters step) {
  const auto from = p;
  for (bool is_whole = true;; is_whole = false) {
    for (std::size_t j = 0; j < p.size(); ++j) p[j] = from[j] + step[j];
    if (problem.is_admissible(p)) return is_whole;
    if (p == from) return false;
    for (double& part : step) part /= 2;
  }
}

/// Newton in double to the bottom of the basin, until the remaining distance is below `rest` of the
/// parameters. The Hessian costs up to seven times as much as the gradient: it is kept while each step is at
/// most a third of the one before, and corrected by the gradients.
template <int N>
void polish(const DescentProblem<N>& problem, Candidate<N>& candidate, double rest) {
  using Vector = Eigen::Matrix<double, N, 1>;
  auto& p = candidate.parameters;
  double last = 1;
  Vector last_gradient = Vector::Zero(), last_step = Vector::Zero();
  // Three to six steps are usual. Thirty are enough for a start where Ceres gave up.
  for (int i = 0; i < 30; ++i) {
    const bool is_own = !candidate.hessian;
    Vector gradient;
    if (is_own) {
      const auto derivatives = problem.derivatives(p);
      gradient = derivatives.gradient;
      candidate.hessian = derivatives.hessian;
    } else {
      gradient = problem.gradient(p).gradient;
      // A shorter step is rounding of the gradients.
      if (i > 0 && last > 1e-8) correct<N>(*candidate.hessian, last_step, gradient - last_gradient);
    }
    const auto newton = newton_step<double, double, N>(gradient, *candidate.hessian);
    if (!newton.is_finite) {
      candidate.status = Status::not_finite;
      candidate.why = "a Newton step is not finite: the parameters do not move the error independently";
      return;
    }
    const bool is_cut = !take_step<N>(problem, p, newton.step);
    ++candidate.iterations;
    candidate.status = is_cut ? Status::at_border : Status::not_converged;
    if (is_cut) {
      candidate.hessian.reset();
      continue;
    }
    // With the Hessian of this place, a step squares the relative distance. With an older Hessian, the share
    // of the step that remains is the Hessian's error: the same share as after the step before, but at least
    // 1 %, in case that step was small by chance.
    const double size = relative_size(newton.step, p);
    const double left = is_own ? size * size : size * std::max(0.01, i == 0 ? 1 : size / last);
    if (size < 1e-6 && left < rest) {
      candidate.status = is_minimum<N>(*candidate.hessian) ? Status::converged : Status::not_converged;
      if (candidate.status != Status::converged) candidate.why = "Newton's method did not find a minimum";
      return;
    }
    if (!(size < last / 3)) candidate.hessian.reset();
    last = size;
    last_gradient = gradient;
    last_step = Eigen::Map<const Vector>(newton.step.data());
  }
  if (candidate.status != Status::at_border) candidate.why = "thirty Newton steps did not settle";
}

/// Whether two points are one optimum: their distance is small, or their errors differ by less than 1e-10 of
/// their norm. The second test is for a parameter near 0, which has few digits. In a fit that can be settled,
/// rounding moves the errors by at most a hundredth of that.
template <int N>
bool is_same_optimum(const DescentProblem<N>& problem, const Candidate<N>& one, const Candidate<N>& other) {
  if (distance(one.parameters, other.parameters) <= same_optimum) return true;
  Eigen::Matrix<double, N, 1> apart;
  for (int i = 0; i < N; ++i) {
    const auto j = static_cast<std::size_t>(i);
    apart[i] = one.parameters[j] - other.parameters[j];
  }
  return apart.dot(*other.hessian * apart) <= 1e-20 * problem.square(other.parameters);
}

/// Whether the cost falls on or stays constant as the parameters grow.
template <int N>
bool is_far_end(const DescentProblem<N>& problem, typename DescentProblem<N>::Parameters p) {
  const double here = problem.square(p);
  for (double& parameter : p) parameter *= 4;
  return problem.square(p) <= here;
}

/// The three starts of a descent.
template <int N>
using Starts = std::array<typename DescentProblem<N>::Parameters, 3>;

/// The optimum on few nodes, if all given starts lead to it; else the status says why not. The Hessian of the
/// first descent serves the other starts and the larger rules.
template <int N>
Candidate<N> common_optimum_by(const Patience& patience, const Starts<N>& starts,
                               const DescentProblem<N>& problem, std::size_t asked) {
  Candidate<N> common{.parameters = starts[0]};
  const double square = problem.square(starts[0]);
  if (!std::isfinite(square)) {
    common.status = Status::not_finite;
    common.why = "the error at the start is not finite";
    return common;
  }
  if (!(square > 0)) {
    common.why = "the square of the error is below the least double";
    return common;
  }

  const TinyFunction<N> function(problem, square);
  auto solver = basin_solver<N>(patience);
  const auto descend = [&](Candidate<N> candidate) {
    typename TinySolver<N>::Parameters parameters(candidate.parameters.data());
    candidate.iterations = solver.Solve(function, &parameters).iterations;
    const bool is_at_border = function.is_turned_back();
    std::copy_n(parameters.data(), N, candidate.parameters.begin());
    const auto before = candidate.parameters;
    polish<N>(problem, candidate, same_optimum / 10);
    if (candidate.status != Status::converged && is_at_border) {
      candidate.status = Status::at_border;
    } else if (candidate.status != Status::converged && is_far_end<N>(problem, before)) {
      candidate.why = "the error is not larger if all parameters are four times as large: there is no best";
    }
    return candidate;
  };
  common = descend(common);
  if (common.status != Status::converged) return common;
  const auto first = common;
  for (std::size_t i = 1; i < asked; ++i) {
    const auto candidate = descend({.parameters = starts[i], .hessian = first.hessian});
    if (candidate.status != Status::converged) {
      common.status = candidate.status;
      common.why = candidate.why;
    } else if (common.status == Status::converged && !is_same_optimum<N>(problem, candidate, first)) {
      common.status = Status::ambiguous;
      common.why = "the starts led to different optima";
    }
  }
  return common;
}

/// The same with few steps, and with many only if that fails.
template <int N>
Candidate<N> common_optimum(const Starts<N>& starts, const DescentProblem<N>& problem,
                            std::size_t asked = 3) {
  const auto common = common_optimum_by<N>(hasty, starts, problem, asked);
  return common.status == Status::converged ? common : common_optimum_by<N>(patient, starts, problem, asked);
}

}  // namespace shadefit
