#include "fit/least_squares/descent.hpp"

#include <algorithm>
#include <cmath>

#include "fit/least_squares/levenberg.hpp"
#include "fit/least_squares/newton.hpp"

namespace shadefit {
namespace {

using Vector = ParameterVector<double>;

/// The roots of the weights of the nodes, scaled so that the errors at the start have norm 1.
using Roots = std::array<double, basin_nodes>;

/// What Ceres minimises: sqrt(weight) * error, scaled to norm 1 at the start. TinySolver stops at absolute
/// changes of the cost, and the cost of a lobe of exponent 1e6 is 1e-19 from the beginning.
///
/// After a step it asks for the errors, and once it has accepted the step, for the errors and their
/// derivatives at the same place. Both are computed together, and the last result is kept.
class ScaledErrors {
 public:
  /// Refers to the problem and the roots.
  ScaledErrors(const SampledErrors& problem, const Roots& roots, const Vector& start)
      : problem_(problem), roots_(roots), place_(start) {
    evaluate();
  }

  void operator()(const double* parameters, double* residuals, double* jacobian) {
    if (!std::equal(place_.begin(), place_.end(), parameters)) {
      std::copy_n(parameters, place_.size(), place_.begin());
      evaluate();
    }
    std::copy(residuals_.begin(), residuals_.end(), residuals);
    if (jacobian != nullptr) std::copy_n(jacobian_.begin(), size(), jacobian);
  }

  /// Whether the last requested place is outside of the admissible parameters.
  bool is_turned_back() const { return is_turned_back_; }

 private:
  std::size_t size() const { return static_cast<std::size_t>(place_.size()) * basin_nodes; }

  void evaluate() {
    problem_.errors(values_of(place_), residuals_, std::span(jacobian_).first(size()));
    // An infinite cost rejects a step.
    is_turned_back_ = !problem_.is_admissible(values_of(place_));
    if (is_turned_back_) residuals_.fill(HUGE_VAL);
    for (std::size_t node = 0; node < basin_nodes; ++node) {
      residuals_[node] *= roots_[node];
      for (std::size_t i = node; i < size(); i += basin_nodes) jacobian_[i] *= roots_[node];
    }
  }

  const SampledErrors& problem_;
  const Roots& roots_;
  Vector place_;
  bool is_turned_back_;
  std::array<double, basin_nodes> residuals_;
  std::array<double, basin_nodes * most_fitted> jacobian_;
};

/// Only the basin is needed: a step of 1e-2 (|x| + 1e-2) usually ends where Newton converges.
constexpr Patience hasty{1e-2, 50};
/// On a steep wall, steps are damped below 1e-2 far from any basin, and Newton's first step would leave it
/// for good. Steps of Levenberg and Marquardt always go down: twenty to forty of them reach a place that
/// Newton confirms.
constexpr Patience patient{1e-7, 400};

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
  Candidate common{.parameters = starts[0]};
  const double square = problem.square(values_of(starts[0]));
  if (!std::isfinite(square)) {
    common.status = Status::not_finite;
    common.why = "the error at the start is not finite";
    return common;
  }
  if (!(square > 0)) {
    common.why = "the square of the error is below the least double";
    return common;
  }

  Roots roots;
  for (std::size_t i = 0; i < basin_nodes; ++i) roots[i] = std::sqrt(problem.weight(i) / square);
  const auto optimum_from = [&](Candidate candidate) {
    ScaledErrors errors(problem, roots, candidate.parameters);
    candidate.iterations = descend({basin_nodes, std::ref(errors)}, patience, candidate.parameters);
    const Vector before = candidate.parameters;
    polish(problem, candidate, same_optimum / 10);
    if (candidate.status != Status::converged && errors.is_turned_back()) {
      candidate.status = Status::at_border;
    } else if (candidate.status != Status::converged && is_far_end(problem, before)) {
      candidate.why = "four times all parameters have no larger error: the form has no best ones";
    }
    return candidate;
  };
  common = optimum_from(common);
  if (common.status != Status::converged) return common;
  const Candidate first = common;
  for (std::size_t i = 1; i < asked; ++i) {
    const Candidate candidate = optimum_from({.parameters = starts[i], .hessian = first.hessian});
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
    const Sums<double> sums = is_own ? problem.derivatives(values_of(p)) : problem.gradient(values_of(p));
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
