#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/scalars/integral.hpp"
#include "fit/squares/linear_optimum.hpp"
#include "fit/squares/settle.hpp"
#include "fit/steps/digits.hpp"
#include "fit/steps/scaled_hessian.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

/// An optimum, and how far it may still move.
struct Settled {
  std::vector<double> parameters;
  long double size;  ///< of the largest step, relative to its parameter
  std::string why;   ///< the reason why it has too few digits, if it has
};

/// The best of the optima by one rule after the other, until the next one moves no digit. `optimum_on` gives
/// that of some nodes, if their columns are not `dependent`, and the size of the target there; `settled_by`
/// compares two of them.
template <class OptimumOn, class SettledBy>
StudyFit best_of_rules(const Rules& rules, std::size_t most_nodes, const std::string& dependent,
                       const OptimumOn& optimum_on, const SettledBy& settled_by) {
  StudyFit fit;
  fit.why = "the integral of the squared error does not converge";
  long double best = HUGE_VALL;
  StudyNodes nodes = rules.nodes(rules.first());
  auto fine = optimum_on(nodes);
  for (std::size_t rule = rules.first(); rule < rules.last() && nodes.size() < most_nodes; ++rule) {
    const auto coarse = std::move(fine).first;
    const long double coarse_total = nodes.total;
    nodes = rules.nodes(rule + 1);
    fine = optimum_on(nodes);
    const auto& [optimum, norm] = fine;
    if (!optimum) fit.why = dependent;
    if (!coarse || !optimum) continue;
    // Below this the square is rounding. A density may have no integral where the squared error has one.
    const long double rounding = 1e-20L * norm * norm, shrinking = coarse_total / nodes.total;
    if (std::abs(coarse->square * shrinking - optimum->square) > 1e-6L * optimum->square + rounding) continue;
    const Settled found = settled_by(*coarse, *optimum, norm);
    if (!(found.size < best)) continue;
    best = found.size;
    fit.parameters = found.parameters;
    fit.digits = correct_digits(best);
    fit.rms_error = static_cast<double>(std::sqrt(optimum->square));
    fit.status = fit.digits < least_study_digits ? Status::not_converged : Status::converged;
    fit.why = fit.status == Status::converged ? "" : found.why;
    if (best <= settled) break;
  }
  return fit;
}

/// The optimum of a linear form over nodes, by orthogonal columns in long double.
struct ColumnsOptimum {
  VectorOf<long double> parameters, last_step, sizes;  ///< `sizes` of the columns
  long double square;
};

/// Empty if a column is dependent.
std::optional<ColumnsOptimum> optimum_of(const SampledStudy<long double>& sampled) {
  constexpr int rounds = 3;  // each takes the rounding of the one before it
  // A column is dependent if those before it leave less of it than this share: 64 bits have 1e-19, and the
  // sums over some thousands of nodes lose two digits.
  constexpr long double least_share = 1e-17L;
  ColumnsOptimum found;
  std::vector<long double> parameters(sampled.parameter_count());
  for (int round = 0; round < rounds; ++round) {
    const WeightedErrors<long double> all = sampled.reduced(parameters);
    const VectorOf<long double> errors = all.errors.cwiseProduct(all.roots);
    MatrixOf<long double> columns = all.roots.asDiagonal() * all.slopes;
    found.sizes = columns.colwise().norm().transpose();
    columns = columns * found.sizes.cwiseInverse().asDiagonal();
    if (!columns.allFinite()) return std::nullopt;
    // On the diagonal stands what the columns before it leave of a column, in the last column Q^T errors.
    LongMatrix with_errors(columns.rows(), columns.cols() + 1);
    with_errors << columns, errors;
    const LongMatrix packed = packed_qr(with_errors).topRows(columns.cols());
    if (packed.diagonal().cwiseAbs().minCoeff() < least_share) return std::nullopt;
    found.square = errors.squaredNorm();
    VectorOf<long double> step = packed.rightCols<1>();
    packed.leftCols(columns.cols()).triangularView<Eigen::Upper>().solveInPlace(step);
    found.last_step = -step.cwiseQuotient(found.sizes);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      parameters[i] += found.last_step[static_cast<Eigen::Index>(i)];
  }
  found.parameters = Eigen::Map<const VectorOf<long double>>(parameters.data(), found.sizes.size());
  return found;
}

/// The optimum of a form that is linear in all parameters, in long double.
StudyFit settle_linear(const Rules& rules) {
  const std::string dependent =
      "long double does not tell six digits of its parameters, whose columns are nearly dependent";
  const auto optimum_on = [&](const StudyNodes& nodes) {
    const auto wide = rules.sampled<long double>(nodes);
    return std::pair(optimum_of(wide), wide.target_norm());
  };
  const auto settled_by = [&](const ColumnsOptimum& coarse, const ColumnsOptimum& fine,
                              long double norm) -> Settled {
    const VectorOf<long double> by_rule = (coarse.parameters - fine.parameters).cwiseAbs(),
                                by_rounding = fine.last_step.cwiseAbs(), step = by_rule + by_rounding;
    const std::vector<double> parameters(fine.parameters.begin(), fine.parameters.end());
    const MatrixOf<double> hessian = fine.sizes.cwiseAbs2().cast<double>().asDiagonal();
    return {parameters, relative_size(step, parameters, hessian, static_cast<double>(norm)),
            by_rounding.maxCoeff() > by_rule.maxCoeff() ? dependent : still_moved};
  };
  return best_of_rules(rules, std::numeric_limits<std::size_t>::max(), dependent, optimum_on, settled_by);
}

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

/// The optimum in 50 digits. `start` is near it, or the form is linear in all parameters.
StudyFit settle_in_50_digits(const ReadStudy& study, const Rules& rules, const std::vector<double>& start) {
  constexpr std::size_t most_nodes = 30000;
  constexpr long double of_50_digits = 1e-48L;
  const auto optimum_on = [&](const StudyNodes& nodes) {
    return std::pair(optimum_in_50_digits(study, nodes, start),
                     rules.sampled<long double>(nodes).target_norm());
  };
  const auto settled_by = [&](const LinearOptimum& coarse, const LinearOptimum& fine, long double norm) {
    const auto step = (coarse.parameters - fine.parameters).cwiseAbs() + fine.last_step.cwiseAbs();
    const long double error = rounding_of_nodes(study) * std::sqrt(fine.square) + of_50_digits * norm;
    // The roundings may move a parameter by more than its value. Then it counts as 0.
    Settled result{std::vector<double>(start.size()), 0, still_moved};
    for (std::size_t i = 0; i < start.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const long double value = fine.parameters[k], moved = error * fine.spread[k];
      if (std::abs(value) <= moved) continue;
      result.parameters[i] = static_cast<double>(value);
      result.size = std::max(result.size, (step[k] + moved) / std::abs(value));
    }
    return result;
  };
  return best_of_rules(rules, most_nodes,
                       "50 digits do not tell its parameters, whose columns are nearly dependent", optimum_on,
                       settled_by);
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
  if (fit.status != Status::degenerate) fail(fit, Status::not_converged, precise.why);
  return fit;
}

}  // namespace shadefit
