#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study_squares/linear_optimum.hpp"
#include "fit/study_squares/settle.hpp"

namespace shadefit {
namespace {

/// The roundings of nodes and weights in long double, as a share of the error.
long double rounding_of_nodes(const ReadStudy& study) {
  long double farthest = 1;
  for (const StudyAxis& axis : study.axes) {
    const double far = std::max(std::abs(axis.lower), std::abs(axis.upper));
    if (!study.rows) farthest = std::max<long double>(farthest, far / (axis.upper - axis.lower));
  }
  return 64 * std::numeric_limits<long double>::epsilon() * farthest;
}

/// The largest step of a parameter, relative. A parameter that is no more than the roundings becomes 0.
long double size_in_50_digits(const ReadStudy& study, const LinearOptimum& found,
                              const VectorOf<long double>& step, long double target_norm,
                              std::vector<double>& parameters) {
  constexpr long double of_50_digits = 1e-48L;
  const long double error = rounding_of_nodes(study) * std::sqrt(found.square) + of_50_digits * target_norm;
  long double size = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const long double least = error * found.spread[k], magnitude = std::abs(found.parameters[k]);
    if (magnitude <= least) parameters[i] = 0;
    if (magnitude > least) size = std::max(size, (step[k] + least) / magnitude);
  }
  return size;
}

}  // namespace

bool needs_50_digits(const ReadStudy& study, const SampledStudy<double>& sampled,
                     const std::vector<double>& parameters) {
  constexpr std::size_t most_nodes = 3000;  // more take a second
  if (sampled.size() > most_nodes || integral_depth(error_formula(study)) > 0) return false;
  constexpr double roundings = 16 * static_cast<double>(std::numeric_limits<long double>::epsilon());
  const MatrixOf<double> hessian = sampled.derivatives(parameters).hessian;
  const VectorOf<double> spread = ScaledHessian(hessian).inverse().diagonal().cwiseAbs().cwiseSqrt();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double moved = roundings * sampled.target_norm() * spread[static_cast<Eigen::Index>(i)];
    if (!(moved <= settled * std::abs(parameters[i]))) return true;
  }
  return false;
}

StudyFit settle_columns(const ReadStudy& study, const Rules& rules, const std::vector<double>& start) {
  constexpr std::size_t most_nodes = 30000;
  StudyFit fit;
  fit.status = Status::not_converged;
  fit.why = "the integral of the squared error does not converge";
  long double best = HUGE_VALL;
  StudyNodes nodes = rules.nodes(rules.first());
  auto fine = optimum_in_50_digits(study, nodes, start);
  for (std::size_t rule = rules.first(); rule < rules.last() && nodes.weights.size() < most_nodes; ++rule) {
    const auto coarse = fine;
    const long double coarse_total = nodes.total;
    nodes = rules.nodes(rule + 1);
    const long double norm = rules.sampled<long double>(nodes).target_norm();
    fine = optimum_in_50_digits(study, nodes, start);
    if (!fine) fit.why = "50 digits do not tell its parameters, whose columns are nearly dependent";
    if (!coarse || !fine) continue;
    // Below this the square is rounding. A density may have no integral where the squared error has one.
    const long double rounding = 1e-20L * norm * norm, shrinking = coarse_total / nodes.total;
    if (std::abs(coarse->square * shrinking - fine->square) > 1e-6L * fine->square + rounding) continue;
    const VectorOf<long double> step =
        (coarse->parameters - fine->parameters).cwiseAbs() + fine->last_step.cwiseAbs();
    std::vector<double> parameters(fine->parameters.begin(), fine->parameters.end());
    const long double size = size_in_50_digits(study, *fine, step, norm, parameters);
    if (!(size < best)) continue;
    best = size;
    fit.parameters = parameters;
    fit.digits = correct_digits(size);
    fit.rms_error = static_cast<double>(std::sqrt(fine->square));
    if (fit.digits >= least_study_digits) fit.status = Status::converged;
    fit.why = "the largest quadrature rule still moves a parameter in its sixth digit";
    if (size <= settled) break;
  }
  if (fit.status == Status::converged) fit.why = "";
  return fit;
}

}  // namespace shadefit
