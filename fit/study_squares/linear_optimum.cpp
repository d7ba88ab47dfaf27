#include "fit/study_squares/linear_optimum.hpp"

#include "fit/support/decompositions.hpp"

namespace shadefit {

std::optional<LinearOptimum> linear_optimum(std::size_t parameter_count, const LinearErrors& errors) {
  using Vector = LinearOptimum::Vector;
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  constexpr int rounds = 3;  // each takes the rounding of the one before it
  // A column is dependent if the others leave less of it than this share: 64 bits have 1e-19, and the sums
  // over some thousands of nodes lose two digits.
  constexpr long double least_share = 1e-17L;
  LinearOptimum found;
  std::vector<long double> parameters(parameter_count);
  for (int round = 0; round < rounds; ++round) {
    Vector here;
    Matrix columns;
    errors(parameters, here, columns);
    found.sizes = columns.colwise().norm().transpose();
    columns = columns * found.sizes.cwiseInverse().asDiagonal();
    Eigen::ColPivHouseholderQR<Matrix> factors(columns);
    factors.setThreshold(least_share);
    if (!columns.allFinite() || factors.rank() < columns.cols()) return std::nullopt;
    found.square = here.squaredNorm();
    found.last_step = -factors.solve(here).cwiseQuotient(found.sizes);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      parameters[i] += found.last_step[static_cast<Eigen::Index>(i)];
  }
  found.parameters =
      Eigen::Map<const Vector>(parameters.data(), static_cast<Eigen::Index>(parameters.size()));
  return found;
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target) {
  return solution(pivoted_qr(columns), target);
}

}  // namespace shadefit
