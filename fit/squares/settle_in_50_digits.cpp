#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fit/scalars/integral.hpp"
#include "fit/squares/linear_optimum.hpp"
#include "fit/squares/settle.hpp"
#include "fit/steps/digits.hpp"
#include "fit/steps/scaled_hessian.hpp"

namespace shadefit {
namespace {

constexpr long double wide_rounding = std::numeric_limits<long double>::epsilon();

/// The roundings of nodes and weights in long double, as a share of the error.
long double rounding_of_nodes(const ReadStudy& study) {
  long double farthest = 1;
  for (const StudyAxis& axis : study.axes) {
    const long double far = std::max(std::abs(axis.lower), std::abs(axis.upper));
    if (!study.rows) farthest = std::max(farthest, far / (axis.upper - axis.lower));
  }
  return 64 * wide_rounding * farthest;
}

/// Whether a parameter may move in its last digits by the roundings of errors in long double, which are
/// shares of the target, and the nodes are few enough for errors in 50 digits. Without parameters, which did
/// not settle, it may.
bool needs_50_digits(const ReadStudy& study, const SampledStudy<double>& sampled,
                     const std::vector<double>& parameters) {
  constexpr std::size_t most_nodes = 3000;  // more take a second
  // Fits near given starts are compared with printed digits, which are fewer.
  if (study.has_only_starts || sampled.size() > most_nodes) return false;
  const auto has_integral = [&] { return integral_depth(error_formula(study)) > 0; };
  if (parameters.empty()) return !has_integral();
  const VectorOf<double> spread =
      ScaledHessian(sampled.derivatives(parameters).hessian).inverse().diagonal().cwiseAbs().cwiseSqrt();
  const VectorOf<double> moved = static_cast<double>(16 * wide_rounding) * sampled.target_norm() * spread;
  return !(moved.array() <= settled * vector_of(parameters).array().abs()).all() && !has_integral();
}

/// The optimum in 50 digits, by one rule after the other. `start` is near it, or the form is linear in all
/// parameters.
StudyFit settle_in_50_digits(const ReadStudy& study, const Rules& rules, const std::vector<double>& start) {
  constexpr std::size_t most_nodes = 30000;
  constexpr long double of_50_digits = 1e-48L;
  StudyFit fit;
  fit.why = "the integral of the squared error does not converge";
  long double best = HUGE_VALL;
  StudyNodes nodes = rules.nodes(rules.first());
  auto fine = optimum_in_50_digits(study, nodes, start);
  for (std::size_t rule = rules.first(); rule < rules.last() && nodes.size() < most_nodes; ++rule) {
    const auto coarse = fine;
    const long double coarse_total = nodes.total;
    nodes = rules.nodes(rule + 1);
    fine = optimum_in_50_digits(study, nodes, start);
    if (!fine) fit.why = "50 digits do not tell its parameters, whose columns are nearly dependent";
    if (!coarse || !fine) continue;
    // Below this the square is rounding. A density may have no integral where the squared
    // error has one.
    const long double norm = rules.sampled<long double>(nodes).target_norm(), least = 1e-20L * norm * norm;
    const long double shrinking = coarse_total / nodes.total;
    if (std::abs(coarse->square * shrinking - fine->square) > 1e-6L * fine->square + least) continue;
    const auto step = (coarse->parameters - fine->parameters).cwiseAbs() + fine->last_step.cwiseAbs();
    const long double error = rounding_of_nodes(study) * std::sqrt(fine->square) + of_50_digits * norm;
    // The roundings may move a parameter by more than its value. Then it counts as 0.
    long double size = 0;
    std::vector<double> parameters(start.size());
    for (std::size_t i = 0; i < start.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const long double value = fine->parameters[k], moved = error * fine->spread[k];
      if (std::abs(value) <= moved) continue;
      parameters[i] = static_cast<double>(value);
      size = std::max(size, (step[k] + moved) / std::abs(value));
    }
    if (!(size < best)) continue;
    best = size;
    fit.parameters = parameters;
    fit.digits = correct_digits(size);
    fit.rms_error = static_cast<double>(std::sqrt(fine->square));
    fit.status = fit.digits < least_study_digits ? Status::not_converged : Status::converged;
    fit.why = fit.status == Status::converged
                  ? ""
                  : "the largest quadrature rule still moves a parameter in its sixth digit";
    if (size <= settled) break;
  }
  return fit;
}

}  // namespace

StudyFit with_all_digits(const ReadStudy& study, const Rules& rules, const SampledStudy<double>& sampled,
                         bool is_linear, StudyFit fit) {
  if (fit.status != Status::converged && is_linear) {
    StudyFit linear = settle_linear(rules);
    if (fit.status == Status::not_converged) fit.why = linear.why;
    if (!linear.parameters.empty()) fit = std::move(linear);
  }
  const bool is_converged = fit.status == Status::converged;
  if (is_converged ? rules.has_moving_kinks() : !is_linear) return fit;
  if (!needs_50_digits(study, sampled, is_converged ? fit.parameters : std::vector<double>{})) return fit;
  const std::vector<double> origin(sampled.parameter_count());
  StudyFit precise = settle_in_50_digits(study, rules, is_linear ? origin : fit.parameters);
  if (!precise.parameters.empty()) return precise;
  if (fit.status == Status::degenerate) return fit;
  fit.status = Status::not_converged;
  fit.why = precise.why;
  return fit;
}

}  // namespace shadefit
