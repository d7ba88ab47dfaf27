#include "fit/study/linear_optimum.hpp"

#include <Eigen/QR>
#include <vector>

namespace shadefit {

std::optional<LinearOptimum> linear_optimum(const SampledStudy<long double>& sampled) {
  using Vector = VectorOf<long double>;
  constexpr int rounds = 3;  // each takes the rounding of the one before it
  // A column is dependent if the others leave less of it than this share: 64 bits have 1e-19, and the sums
  // over some thousands of nodes lose two digits.
  constexpr long double least_share = 1e-17L;
  LinearOptimum found;
  std::vector<long double> parameters;
  for (int round = 0; round < rounds; ++round) {
    Vector errors;
    MatrixOf<long double> slopes;
    if (round == 0) parameters.assign(sampled.parameter_count(), 0);
    sampled.errors(parameters, errors, &slopes);
    MatrixOf<long double> columns = sampled.roots().asDiagonal() * slopes;
    found.sizes = columns.colwise().norm().transpose();
    columns = columns * found.sizes.cwiseInverse().asDiagonal();
    Eigen::ColPivHouseholderQR<MatrixOf<long double>> factors(columns);
    factors.setThreshold(least_share);
    if (!columns.allFinite() || factors.rank() < columns.cols()) return std::nullopt;
    const Vector weighted = sampled.roots().cwiseProduct(errors);
    found.square = weighted.squaredNorm();
    found.last_step = -factors.solve(weighted).cwiseQuotient(found.sizes);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      parameters[i] += found.last_step[static_cast<Eigen::Index>(i)];
  }
  found.parameters =
      Eigen::Map<const Vector>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
  return found;
}

}  // namespace shadefit
