#include "fit/support/decompositions.hpp"

#include <algorithm>

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

LongMatrix packed_qr(LongMatrix matrix) {
  // Column by column. Eigen's class works in blocks, which takes ten seconds of a compiler once more.
  Eigen::VectorX<long double> workspace(matrix.cols());
  for (Eigen::Index i = 0; i < std::min(matrix.rows(), matrix.cols()); ++i) {
    auto column = matrix.col(i).tail(matrix.rows() - i);
    long double tau, length;
    column.makeHouseholderInPlace(tau, length);
    column[0] = length;
    matrix.bottomRightCorner(matrix.rows() - i, matrix.cols() - i - 1)
        .applyHouseholderOnTheLeft(column.tail(matrix.rows() - i - 1), tau, workspace.data());
  }
  return matrix;
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
