#include "fit/study_squares/settle.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/scaled_hessian.hpp"
#include "fit/study_squares/linear_optimum.hpp"

namespace shadefit {
namespace {

std::optional<LinearOptimum> optimum_of(const SampledStudy<long double>& sampled) {
  return linear_optimum(sampled.parameter_count(), [&](const auto& parameters, auto& errors, auto& slopes) {
    sampled.errors(parameters, errors, &slopes);
    errors = errors.cwiseProduct(sampled.roots()).eval();
    slopes = (sampled.roots().asDiagonal() * slopes).eval();
  });
}

}  // namespace

StudyFit settle_linear(const Rules& rules) {
  const std::string dependent_columns =
      "long double does not tell six digits of its parameters, whose columns are nearly dependent";
  StudyFit fit;
  fit.status = Status::not_converged;
  fit.why = "the integral of the squared error does not converge";
  long double best = HUGE_VALL;
  StudyNodes nodes = rules.nodes(rules.first());
  auto fine = optimum_of(rules.sampled<long double>(nodes));
  for (std::size_t rule = rules.first(); rule < rules.last(); ++rule) {
    const auto coarse = fine;
    const long double coarse_total = nodes.total;
    nodes = rules.nodes(rule + 1);
    const auto wide = rules.sampled<long double>(nodes);
    fine = optimum_of(wide);
    if (!fine) fit.why = dependent_columns;
    if (!coarse || !fine) continue;
    // Below this the square is rounding. A density may have no integral where the squared error has one.
    const long double rounding = 1e-20L * wide.target_norm() * wide.target_norm();
    const long double shrinking = coarse_total / nodes.total;
    if (std::abs(coarse->square * shrinking - fine->square) > 1e-6L * fine->square + rounding) continue;
    const VectorOf<long double> by_rule = (coarse->parameters - fine->parameters).cwiseAbs(),
                                by_rounding = fine->last_step.cwiseAbs(), step = by_rule + by_rounding;
    const std::vector<double> parameters(fine->parameters.begin(), fine->parameters.end());
    const MatrixOf<double> hessian = fine->sizes.cwiseAbs2().cast<double>().asDiagonal();
    const auto size = relative_size(step, parameters, hessian, static_cast<double>(wide.target_norm()));
    if (!(size < best)) continue;
    best = size;
    fit.parameters = parameters;
    fit.digits = correct_digits(size);
    fit.rms_error = static_cast<double>(std::sqrt(fine->square));
    if (fit.digits >= least_study_digits) fit.status = Status::converged;
    fit.why = by_rounding.maxCoeff() > by_rule.maxCoeff()
                  ? dependent_columns
                  : "the largest quadrature rule still moves a parameter in its sixth digit";
    if (size <= settled) break;
  }
  if (fit.status == Status::converged) fit.why = "";
  return fit;
}

}  // namespace shadefit
