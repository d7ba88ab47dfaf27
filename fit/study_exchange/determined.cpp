#include "fit/study_exchange/determined.hpp"

#include <algorithm>

#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

/// Multipliers sum to 1. One below this is the rounding of 0.
constexpr double vanishing = 1e-9;

/// How large the multiplier of an entering row can become before one of the support reaches 0. `shares`: how
/// much each multiplier of the support falls for a unit of it.
double room(const VectorOf<double>& multipliers, const VectorOf<double>& shares) {
  double least = 1;
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    if (shares[i] > vanishing) least = std::min(least, std::max(0.0, multipliers[i]) / shares[i]);
  }
  return least;
}

}  // namespace

bool are_determined(const MatrixOf<double>& slopes, std::span<const std::size_t> support,
                    std::span<const double> first_multipliers) {
  const Eigen::Index unknowns = slopes.cols(), rows = slopes.rows();
  const VectorOf<double> scale = slopes.cwiseAbs().colwise().maxCoeff();
  // The last coordinate keeps the sum of the multipliers.
  MatrixOf<double> columns(unknowns + 1, rows);
  columns.topRows(unknowns) = (slopes * scale.cwiseInverse().asDiagonal()).transpose();
  columns.bottomRows(1).setOnes();

  MatrixOf<double> of_support(unknowns + 1, unknowns + 1);
  VectorOf<double> multipliers(unknowns + 1);
  for (Eigen::Index i = 0; i <= unknowns; ++i) {
    of_support.col(i) = columns.col(static_cast<Eigen::Index>(support[static_cast<std::size_t>(i)]));
    multipliers[i] = first_multipliers[static_cast<std::size_t>(i)];
  }
  const PivotedQr qr = pivoted_qr(of_support);
  std::vector<bool> is_in(static_cast<std::size_t>(rows), false);
  for (const std::size_t row : support) is_in[row] = true;

  std::vector<Eigen::Index> held;
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    for (Eigen::Index row = 0; row < rows; ++row) {
      if (is_in[static_cast<std::size_t>(row)]) continue;
      const VectorOf<double> shares = solution(qr, columns.col(row));
      const double step = room(multipliers, shares) / 2;
      if (step <= vanishing) continue;
      multipliers -= step * shares;
      is_in[static_cast<std::size_t>(row)] = has_moved = true;
      held.push_back(row);
    }
  }
  for (Eigen::Index i = 0; i <= unknowns; ++i) {
    if (multipliers[i] > vanishing)
      held.push_back(static_cast<Eigen::Index>(support[static_cast<std::size_t>(i)]));
  }
  MatrixOf<double> spanning(unknowns, static_cast<Eigen::Index>(held.size()));
  for (std::size_t i = 0; i < held.size(); ++i)
    spanning.col(static_cast<Eigen::Index>(i)) = columns.col(held[i]).head(unknowns);
  return !held.empty() && pivoted_qr(spanning).rank() == unknowns;
}

}  // namespace shadefit
