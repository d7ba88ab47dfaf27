#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

template <class Decomposition>
Decomposition decomposed(const Eigen::MatrixXd& matrix, double threshold) {
  Decomposition decomposition(matrix.rows(), matrix.cols());
  if (threshold > 0) decomposition.setThreshold(threshold);
  decomposition.compute(matrix);
  return decomposition;
}

}  // namespace

PivotedQr pivoted_qr(const Eigen::MatrixXd& matrix, double threshold) {
  return decomposed<PivotedQr>(matrix, threshold);
}

Eigen::VectorXd solution(const PivotedQr& qr, const Eigen::VectorXd& right) {
  return qr.solve(right);
}

Eigen::MatrixXd basis(const PivotedQr& qr) {
  return qr.householderQ();
}

Eigen::MatrixXd packed_qr(const Eigen::MatrixXd& matrix) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(matrix).matrixQR();
}

Eigen::MatrixXd qr_basis(const Eigen::MatrixXd& matrix) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(matrix).householderQ();
}

Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                  double threshold) {
  return decomposed<Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>>(matrix, threshold).solve(right);
}

Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_of(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric);
}

}  // namespace shadefit
