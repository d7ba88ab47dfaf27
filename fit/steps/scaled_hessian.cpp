#include "fit/steps/scaled_hessian.hpp"

#include <Eigen/LU>

namespace shadefit {

ScaledHessian::ScaledHessian(const ParameterMatrix<double>& hessian)
    : units(hessian.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse()),
      scaled(units.asDiagonal() * hessian * units.asDiagonal()) {}

ParameterMatrix<double> ScaledHessian::inverse() const {
  return units.asDiagonal() * scaled.fullPivLu().inverse() * units.asDiagonal();
}

bool is_minimum(ParameterMatrix<double> hessian) {
  const Eigen::Index n = hessian.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!(hessian(k, k) > 0)) return false;
    for (Eigen::Index i = k + 1; i < n; ++i) {
      for (Eigen::Index j = k + 1; j < n; ++j) hessian(i, j) -= hessian(i, k) * hessian(k, j) / hessian(k, k);
    }
  }
  return true;
}

void clear_rounding(std::span<double> parameters, const ParameterMatrix<double>& hessian,
                    double target_norm) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (std::abs(parameters[i]) * std::sqrt(std::abs(hessian(k, k))) < 1e-16 * target_norm) parameters[i] = 0;
  }
}

}  // namespace shadefit
