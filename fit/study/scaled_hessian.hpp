#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "fit/study/study_problem.hpp"

namespace shadefit {

/// A Hessian with units in which its diagonal is 1: parameters have units, and without this a small one would
/// look like rounding beside a large one.
struct ScaledHessian {
  explicit ScaledHessian(const MatrixOf<double>& hessian)
      : units(hessian.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse()),
        scaled(units.asDiagonal() * hessian * units.asDiagonal()) {}

  MatrixOf<double> inverse() const {
    return units.asDiagonal() * scaled.fullPivLu().inverse() * units.asDiagonal();
  }
  /// Whether all eigenvalues are positive.
  bool is_positive() const { return Eigen::LDLT<MatrixOf<double>>(scaled).isPositive(); }

  VectorOf<double> units;  ///< of the parameters
  MatrixOf<double> scaled;
};

}  // namespace shadefit
