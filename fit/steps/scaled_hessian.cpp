#include "fit/steps/scaled_hessian.hpp"

#include <Eigen/LU>

namespace shadefit {

ScaledHessian::ScaledHessian(const ParameterMatrix<double>& hessian)
    : units(hessian.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse()),
      scaled(units.asDiagonal() * hessian * units.asDiagonal()) {}

ParameterMatrix<double> ScaledHessian::inverse() const {
  return units.asDiagonal() * scaled.fullPivLu().inverse() * units.asDiagonal();
}

void clear_rounding(std::span<double> parameters, const ParameterMatrix<double>& hessian,
                    double target_norm) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (std::abs(parameters[i]) * std::sqrt(std::abs(hessian(k, k))) < 1e-16 * target_norm) parameters[i] = 0;
  }
}

}  // namespace shadefit
