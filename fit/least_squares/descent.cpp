#include "fit/least_squares/descent.hpp"

#include <ceres/tiny_solver.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "fit/least_squares/newton.hpp"

namespace shadefit {
namespace {

using Vector = ParameterVector<double>;

/// What ceres::TinySolver minimises: sqrt(weight) * error, scaled to norm 1 at the start. TinySolver stops at
/// absolute changes of the cost, and the cost of a lobe of exponent 1e6 is 1e-19 from the beginning.
///
/// After a step it asks for the errors, and once it has accepted the step, for the errors and their
/// derivatives at the same place. Both are computed together, and the last result is kept.
class TinyFunction {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = static_cast<int>(basin_nodes), NUM_PARAMETERS = Eigen::Dynamic };

  TinyFunction(const SampledErrors& problem, std::size_t parameters, double square)
      : problem_(problem), count_(parameters) {
    for (std::size_t i = 0; i < basin_nodes; ++i) roots_[i] = std::sqrt(problem_.weight(i) / square);
  }

  int NumParameters() const { return static_cast<int>(count_); }

  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    if (!place_ || !std::equal(place_->begin(), place_->end(), parameters)) move_to(parameters);
    std::copy(residuals_.begin(), residuals_.end(), residuals);
    if (jacobian != nullptr) std::copy_n(jacobian_.begin(), count_ * basin_nodes, jacobian);
    return true;
  }

  /// Whether the last requested place is outside of the admissible parameters.
  bool is_turned_back() const { return is_turned_back_; }

 private:
  void move_to(const double* parameters) const {
    place_ = Eigen::Map<const Vector>(parameters, static_cast<Eigen::Index>(count_));
    const std::span jacobian = std::span(jacobian_).first(count_ * basin_nodes);
    problem_.errors(values_of(*place_), residuals_, jacobian);
    // An infinite cost rejects a step.
    is_turned_back_ = !problem_.is_admissible(values_of(*place_));
    if (is_turned_back_) residuals_.fill(HUGE_VAL);
    for (std::size_t node = 0; node < basin_nodes; ++node) {
      residuals_[node] *= roots_[node];
      for (std::size_t i = 0; i < count_; ++i) jacobian[i * basin_nodes + node] *= roots_[node];
    }
  }

  const SampledErrors& problem_;
  std::size_t count_;
  std::array<double, basin_nodes> roots_{};  ///< of the weights, scaled
  mutable std::optional<Vector> place_ = std::nullopt;
  mutable bool is_turned_back_ = false;
  mutable std::array<double, basin_nodes> residuals_{};
  mutable std::array<double, basin_nodes * most_fitted> jacobian_{};
};

using BasinSolver = ceres::TinySolver<TinyFunction, Eigen::LDLT<ParameterMatrix<double>>>;

/// How far Ceres goes before Newton takes over.
struct Patience {
  double last_step;  ///< it ends with a step below this, relative
  int most_steps;
};

/// Only the basin is needed: a step of 1e-2 (|x| + 1e-2) usually ends where Newton converges.
constexpr Patience hasty{1e-2, 50};
/// On a steep wall, steps are damped below 1e-2 far from any basin, and Newton's first step would leave it
/// for good. Steps of Levenberg and Marquardt always go down: twenty to forty of them reach a place that
/// Newton confirms.
constexpr Patience patient{1e-7, 400};

/// Cost tests are off.
void set_patience(BasinSolver::Options& options, const Patience& patience) {
  options.parameter_tolerance = patience.last_step;
  options.max_num_iterations = patience.most_steps;
  options.function_tolerance = 0;
  options.gradient_tolerance = 0;
  options.cost_threshold = 0;
}

/// Takes a step, or the first of its half, quarter, .. that leaves the parameters admissible. False if the
/// step was cut. Takes nothing if the parameters are not admissible before the step.
bool take_step(const SampledErrors& problem, Vector& p, Vector step) {
  const Vector from = p;
  for (bool is_whole = true;; is_whole = false) {
    p = from + step;
    if (problem.is_admissible(values_of(p))) return is_whole;
    if (p == from) return false;
    step /= 2;
  }
}

/// Whether two points are one optimum: their distance is small, relative to the second, or their errors
/// differ by less than 1e-10 of their norm. The second test is for a parameter near 0, which has few digits.
/// In a fit that can be settled, rounding moves the errors by at most a hundredth of that.
bool is_same_optimum(const SampledErrors& problem, const Candidate& one, const Candidate& other) {
  const Vector apart = one.parameters - other.parameters;
  if (relative_size(apart, other.parameters) <= same_optimum) return true;
  return apart.dot(*other.hessian * apart) <= 1e-20 * problem.square(values_of(other.parameters));
}

/// Whether the cost falls on or stays constant as the parameters grow.
bool is_far_end(const SampledErrors& problem, const Vector& p) {
  const Vector further = 4 * p;
  return problem.square(values_of(further)) <= problem.square(values_of(p));
}

Candidate common_optimum_by(const Patience& patience, const Starts& starts, const SampledErrors& problem,
                            std::size_t asked) {
  Candidate common{.parameters = vector_of(starts[0])};
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

  const TinyFunction function(problem, starts[0].size(), square);
  BasinSolver solver;
  set_patience(solver.options, patience);
  const auto descend = [&](Candidate candidate) {
    BasinSolver::Parameters parameters = candidate.parameters;
    candidate.iterations = solver.Solve(function, &parameters).iterations;
    const bool is_at_border = function.is_turned_back();
    candidate.parameters = parameters;
    polish(problem, candidate, same_optimum / 10);
    if (candidate.status != Status::converged && is_at_border) {
      candidate.status = Status::at_border;
    } else if (candidate.status != Status::converged && is_far_end(problem, parameters)) {
      candidate.why = "the error is not larger if all parameters are four times as large: there is no best";
    }
    return candidate;
  };
  common = descend(common);
  if (common.status != Status::converged) return common;
  const Candidate first = common;
  for (std::size_t i = 1; i < asked; ++i) {
    const Candidate candidate = descend({.parameters = vector_of(starts[i]), .hessian = first.hessian});
    if (candidate.status != Status::converged) {
      common.status = candidate.status;
      common.why = candidate.why;
    } else if (common.status == Status::converged && !is_same_optimum(problem, candidate, first)) {
      common.status = Status::ambiguous;
      common.why = "the starts led to different optima";
    }
  }
  return common;
}

}  // namespace

void polish(const SampledErrors& problem, Candidate& candidate, double rest) {
  Vector& p = candidate.parameters;
  double last = 1;
  Vector last_gradient, last_step;
  // Three to six steps are usual. Thirty are enough for a start where Ceres gave up.
  for (int i = 0; i < 30; ++i) {
    const bool is_own = !candidate.hessian;
    const Sums<double> sums =
        is_own ? problem.derivatives(values_of(p)) : problem.gradient(values_of(p));
    if (is_own) {
      candidate.hessian = sums.hessian;
    } else if (i > 0 && last > 1e-8) {
      // A shorter step is rounding of the gradients.
      correct(*candidate.hessian, last_step, sums.gradient - last_gradient);
    }
    const Vector step = newton_step(sums.gradient, *candidate.hessian);
    if (!step.allFinite()) {
      candidate.status = Status::not_finite;
      candidate.why = "a Newton step is not finite: the parameters do not move the error independently";
      return;
    }
    const bool is_cut = !take_step(problem, p, step);
    ++candidate.iterations;
    candidate.status = is_cut ? Status::at_border : Status::not_converged;
    if (is_cut) {
      candidate.hessian.reset();
      continue;
    }
    // With the Hessian of this place, a step squares the relative distance. With an older Hessian, the share
    // of the step that remains is the Hessian's error: the same share as after the step before, but at least
    // 1 %, in case that step was small by chance.
    const double size = relative_size(step, p);
    const double left = is_own ? size * size : size * std::max(0.01, i == 0 ? 1 : size / last);
    if (size < 1e-6 && left < rest) {
      candidate.status = is_minimum(*candidate.hessian) ? Status::converged : Status::not_converged;
      if (candidate.status != Status::converged) candidate.why = "Newton's method did not find a minimum";
      return;
    }
    if (!(size < last / 3)) candidate.hessian.reset();
    last = size;
    last_gradient = sums.gradient;
    last_step = step;
  }
  if (candidate.status != Status::at_border) candidate.why = "thirty Newton steps did not settle";
}

Candidate common_optimum(const Starts& starts, const SampledErrors& problem, std::size_t asked) {
  const Candidate common = common_optimum_by(hasty, starts, problem, asked);
  return common.status == Status::converged ? common : common_optimum_by(patient, starts, problem, asked);
}

}  // namespace shadefit
