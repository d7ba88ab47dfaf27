#include "fit/least_squares/scaled_hessian.hpp"

#include <Eigen/LU>

namespace shadefit {

ScaledHessian::ScaledHessian(const ParameterMatrix<double>& hessian)
    : units(hessian.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse()),
      scaled(units.asDiagonal() * hessian * units.asDiagonal()) {}

ParameterMatrix<double> ScaledHessian::inverse() const {
  return units.asDiagonal() * scaled.fullPivLu().inverse() * units.asDiagonal();
}

}  // namespace shadefit
