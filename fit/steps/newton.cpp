#include "fit/steps/newton.hpp"

#include <Eigen/LU>
#include <array>
#include <cstddef>

namespace shadefit {
namespace {

template <int N>
ParameterMatrix<double> inverse_of(const ParameterMatrix<double>& hessian) {
  return Eigen::Map<const Eigen::Matrix<double, N, N>>(hessian.data()).inverse();
}

}  // namespace

ParameterMatrix<double> inverse(const ParameterMatrix<double>& hessian) {
  // Up to four rows have closed forms, which take a tenth of the time.
  switch (hessian.rows()) {
    case 1:
      return inverse_of<1>(hessian);
    case 2:
      return inverse_of<2>(hessian);
    case 3:
      return inverse_of<3>(hessian);
    case 4:
      return inverse_of<4>(hessian);
    default:
      return hessian.fullPivLu().inverse();
  }
}

bool is_minimum(const ParameterMatrix<double>& hessian) {
  std::array<double, std::size_t{most_fitted} * most_fitted> rows;
  std::copy_n(hessian.data(), hessian.size(), rows.begin());
  const auto n = static_cast<std::size_t>(hessian.rows());
  return is_positive_definite(rows, n, [](double pivot) { return pivot > 0; });
}

void correct(ParameterMatrix<double>& hessian, const ParameterVector<double>& step,
             const ParameterVector<double>& change) {
  const ParameterVector<double> surprise = change - hessian * step;
  const double along = surprise.dot(step);
  if (std::abs(along) > 1e-8 * surprise.norm() * step.norm())
    hessian += surprise * surprise.transpose() / along;
}

}  // namespace shadefit
