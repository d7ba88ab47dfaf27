#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/least_squares/digits.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study_squares/linear_optimum.hpp"
#include "fit/study_squares/settle.hpp"

namespace shadefit {
namespace {

constexpr long double rounding = std::numeric_limits<long double>::epsilon();

/// The roundings of nodes and weights in long double, as a share of the error.
long double rounding_of_nodes(const ReadStudy& study) {
  long double farthest = 1;
  for (const StudyAxis& axis : study.axes) {
    const long double far = std::max(std::abs(axis.lower), std::abs(axis.upper));
    if (!study.rows) farthest = std::max(farthest, far / (axis.upper - axis.lower));
  }
  return 64 * rounding * farthest;
}

}  // namespace

bool needs_50_digits(const ReadStudy& study, const SampledStudy<double>& sampled,
                     const std::vector<double>& parameters) {
  constexpr std::size_t most_nodes = 3000;  // more take a second
  // Fits near given starts are compared with printed digits, which are fewer.
  if (study.has_only_starts || sampled.size() > most_nodes || integral_depth(error_formula(study)) > 0)
    return false;
  if (parameters.empty()) return true;
  const VectorOf<double> spread =
      ScaledHessian(sampled.derivatives(parameters).hessian).inverse().diagonal().cwiseAbs().cwiseSqrt();
  const VectorOf<double> moved = static_cast<double>(16 * rounding) * sampled.target_norm() * spread;
  return !(moved.array() <= settled * vector_of(parameters).array().abs()).all();
}

StudyFit settle_in_50_digits(const ReadStudy& study, const Rules& rules, const std::vector<double>& start) {
  constexpr std::size_t most_nodes = 30000;
  constexpr long double of_50_digits = 1e-48L;
  StudyFit fit;
  fit.why = "the integral of the squared error does not converge";
  long double best = HUGE_VALL;
  StudyNodes nodes = rules.nodes(rules.first());
  auto fine = optimum_in_50_digits(study, nodes, start);
  for (std::size_t rule = rules.first(); rule < rules.last() && nodes.weights.size() < most_nodes; ++rule) {
    const auto coarse = fine;
    const long double coarse_total = nodes.total;
    nodes = rules.nodes(rule + 1);
    fine = optimum_in_50_digits(study, nodes, start);
    if (!fine) fit.why = "50 digits do not tell its parameters, whose columns are nearly dependent";
    if (!coarse || !fine) continue;
    // Below this the square is rounding. A density may have no integral where the squared error has one.
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

}  // namespace shadefit
