#include "fit/squares/settle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fit/steps/digits.hpp"
#include "fit/steps/scaled_hessian.hpp"

namespace shadefit {
namespace {

/// The gradient of half the square, with the range split at the kinks that the parameters move. So it is that
/// of the integral, and smooth.
VectorOf<long double> gradient_at(Rules& rules, std::size_t rule, const std::vector<double>& parameters) {
  rules.move_kinks(parameters);
  const std::vector<long double> at(parameters.begin(), parameters.end());
  return rules.sampled<long double>(rule).gradient(at).gradient;
}

/// Its derivatives by central differences: a kink that moves adds to those of the nodes. `hessian` is theirs.
MatrixOf<double> hessian_with_kinks(Rules& rules, std::size_t rule, const std::vector<double>& parameters,
                                    const MatrixOf<double>& hessian, double target_norm) {
  // Of the third order there remains 1e-10; long double loses 1e-14 or less.
  constexpr double step = 1e-5;
  MatrixOf<double> result = hessian;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double length = step * std::max(std::abs(parameters[i]), target_norm / std::sqrt(hessian(k, k)));
    std::vector<double> above = parameters, below = parameters;
    above[i] += length;
    below[i] -= length;
    const VectorOf<long double> difference =
        gradient_at(rules, rule, above) - gradient_at(rules, rule, below);
    result.col(k) = difference.cast<double>() / (above[i] - below[i]);
  }
  return (result + result.transpose()) / 2;
}

}  // namespace

StudyFit settle_kinks(Rules& rules, const StudyCandidate& candidate) {
  const std::size_t rule = rules.first();
  StudyFit fit;
  fit.parameters = candidate.parameters;
  fit.why = "Newton's method did not find a minimum beside the kinks that the parameters move";
  constexpr int step_limit = 30, stall_limit = 4;
  double square = HUGE_VAL, shortening = 1;
  VectorOf<double> step;
  std::vector<double> at = candidate.parameters, from;
  long double best = HUGE_VALL;
  for (int i = 0, stalls = 0; i < step_limit && stalls < stall_limit; ++i) {
    rules.move_kinks(at);
    const auto& sampled = rules.sampled<double>(rule);
    const auto sums = sampled.derivatives(at);
    const double norm = sampled.target_norm();  // before kinks move: then the samples are forgotten
    // A step that leads up is halved.
    if (!(sums.square <= square * (1 + 1e-12)) && shortening > 1e-4) {
      shortening /= 2;
      at = moved_by<double>(shortening * step, from);
      continue;
    }
    if ((sums.hessian.diagonal().array() == 0).any()) break;
    MatrixOf<double> hessian = hessian_with_kinks(rules, rule, at, sums.hessian, norm);
    const bool is_at_minimum = hessian.allFinite() && is_minimum(ScaledHessian(hessian).scaled);
    if (!is_at_minimum) hessian = sums.hessian;
    const MatrixOf<double> inverse = ScaledHessian(hessian).inverse();
    step = -(inverse * gradient_at(rules, rule, at).cast<double>());
    if (!step.allFinite()) break;
    // The next rule has another error where nothing is smooth, so its step counts the digits.
    const VectorOf<double> check = -(inverse * gradient_at(rules, rule + 1, at).cast<double>());
    const long double size = relative_size(check, at, hessian, norm);
    const bool is_better = is_at_minimum && size < best;
    if (is_better) {
      best = size;
      fit.parameters = at;
      fit.digits = correct_digits(size);
      fit.rms_error = std::sqrt(sums.square);
    }
    stalls = is_better ? 0 : stalls + 1;
    if (best <= settled || (best < 1e-6L && !is_better)) break;
    from = at;
    square = sums.square;
    shortening = 1;
    at = moved_by(step, at);
  }
  rules.move_kinks(fit.parameters);
  const bool is_settled = std::isfinite(best) && fit.digits >= least_study_digits;
  fit.status = is_settled ? Status::converged : Status::not_converged;
  if (is_settled) fit.why = "";
  return fit;
}

}  // namespace shadefit
