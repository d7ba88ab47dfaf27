#include "fit/squares/settle.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "fit/steps/digits.hpp"
#include "fit/steps/scaled_hessian.hpp"

namespace shadefit {
namespace {

/// Newton's method in double from a candidate to the bottom of its basin. Returns the exact Hessian there,
/// and nothing if the basin has no minimum.
std::optional<ParameterMatrix<double>> polish(const SampledStudy<double>& sampled,
                                              std::vector<double>& parameters) {
  double last = HUGE_VAL;
  for (int i = 0; i < 40; ++i) {
    const auto sums = sampled.derivatives(parameters);
    const ScaledHessian hessian(sums.hessian);
    const VectorOf<double> step = -(hessian.inverse() * sums.gradient);
    if (!step.allFinite()) return std::nullopt;
    const auto size =
        static_cast<double>(relative_size(step, parameters, sums.hessian, sampled.target_norm()));
    std::vector<double> next = moved_by(step, parameters);
    if (size < 1e-15 || (size < 1e-10 && size >= last / 2)) {
      return is_minimum(hessian.scaled) ? std::optional(sums.hessian) : std::nullopt;
    }
    // Far from the optimum a step may lead up, or over a pole: then it is halved.
    double scale = 1;
    while (size > 1e-6 && scale > 1e-4 &&
           (!(sampled.square(next) <= sums.square * (1 + 1e-12)) || sampled.has_pole(next))) {
      scale /= 2;
      next = moved_by<double>(scale * step, parameters);
    }
    parameters = next;
    last = size;
  }
  return std::nullopt;
}

}  // namespace

StudyFit settle(const Rules& rules, const StudyCandidate& candidate, const SampledStudy<double>* searched) {
  StudyFit fit;
  fit.parameters = candidate.parameters;
  long double best = HUGE_VALL;
  for (std::size_t rule = rules.first(); rule < rules.last(); ++rule) {
    const bool is_searched = searched != nullptr && rule == rules.first();
    const SampledStudy<double>& fine = is_searched ? *searched : rules.sampled<double>(rule);
    std::vector<double> parameters = fit.parameters;
    const auto hessian = polish(fine, parameters);
    if (!hessian) {
      if (rule + 1 < rules.last() || fit.status == Status::converged) continue;
      fit.why = "Newton's method did not find a minimum";
      return fit;
    }
    const auto& wide = rules.sampled<long double>(rule + 1);
    const std::vector<long double> at(parameters.begin(), parameters.end());
    const auto sums = wide.gradient(at);
    const ParameterMatrix<double> inverse = ScaledHessian(*hessian).inverse();
    const ParameterVector<long double> step = -(inverse.cast<long double>() * sums.gradient);
    const long double size = relative_size(step, parameters, *hessian, fine.target_norm());
    const double square = fine.square(parameters);
    // Below this the square is rounding.
    const double rounding = 1e-20 * fine.target_norm() * fine.target_norm();
    const double apart = std::abs(static_cast<double>(sums.square) - square);
    if (apart > 1e-6 * square + rounding) continue;
    fit.status = Status::converged;
    fit.rms_error = static_cast<double>(std::sqrt(sums.square));
    if (size < best) {
      best = size;
      // The step of the larger rule, in the wider arithmetic, is the better answer.
      fit.parameters = moved_by<long double>(step, parameters);
      clear_rounding(fit.parameters, *hessian, fine.target_norm());
      fit.digits = correct_digits(size);
    }
    // Ten digits of the rms error are printed. That of the larger rule has more than both share.
    if (best <= settled && apart <= 1e-10 * square + rounding) break;
  }
  if (fit.status != Status::converged) {
    fit.why = rules.is_of_rows() ? "Newton's method does not settle in long double"
                                 : "the integral of the squared error does not converge";
  } else if (fit.digits < least_study_digits) {
    fail(fit, Status::not_converged,
         rules.is_of_rows() ? "long double still moves a parameter in its sixth digit" : still_moved);
  }
  return fit;
}

}  // namespace shadefit
