#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fit/squares/settle.hpp"
#include "fit/steps/digits.hpp"
#include "fit/steps/scaled_hessian.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

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
