#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

/// Eigen's decompositions of dense matrices, compiled in one place: each takes seconds of a compiler. The
/// objects that come back are cheap to read, but their solve() and householderQ() are not cheap to compile:
/// here are functions for them.
namespace shadefit {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using PivotedQr = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

/// Q R with the longest column first, as far as columns are longer than `threshold` of the longest; 0 stands
/// for the rounding of doubles.
PivotedQr pivoted_qr(const Eigen::MatrixXd& matrix, double threshold = 0);

/// The least squares solution of Q R x = right.
Eigen::VectorXd solution(const PivotedQr& qr, const Eigen::VectorXd& right);

/// The whole of Q, square.
Eigen::MatrixXd basis(const PivotedQr& qr);

/// Q R without pivots, packed as Eigen does: R in the upper triangle.
Eigen::MatrixXd packed_qr(const Eigen::MatrixXd& matrix);
LongMatrix packed_qr(LongMatrix matrix);

/// The whole of Q of Q R without pivots, square.
Eigen::MatrixXd qr_basis(const Eigen::MatrixXd& matrix);

/// The shortest x with the least |matrix x - right|; columns below `threshold` of the longest count as 0, and
/// 0 stands for the rounding of doubles.
Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                  double threshold = 0);

/// The eigenvalues of a symmetric matrix in rising order, and its eigenvectors.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_of(const Eigen::MatrixXd& symmetric);

}  // namespace shadefit
