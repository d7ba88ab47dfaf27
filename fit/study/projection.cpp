#include "fit/study/projection.hpp"

#include <Eigen/QR>
#include <cmath>

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

/// Columns of the slopes, each times sqrt(weight).
Matrix columns_of(const Matrix& slopes, const std::vector<std::size_t>& which, const Vector& roots) {
  Matrix columns(slopes.rows(), static_cast<Eigen::Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) =
        slopes.col(static_cast<Eigen::Index>(which[i])).cwiseProduct(roots);
  return columns;
}

}  // namespace

Projection::Projection(const StudyError& error, const SampledStudy<double>& sampled,
                       std::optional<std::size_t> held)
    : sampled_(sampled), held_(held), parameters_(error.parameter_count()) {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (i != held) (error.is_linear()[i] ? linear_ : nonlinear_).push_back(i);
  }
}

bool Projection::operator()(const double* q, double* residuals, double* jacobian) const {
  for (std::size_t i = 0; i < nonlinear_.size(); ++i) parameters_[nonlinear_[i]] = q[i];
  Eigen::Map<Vector> result(residuals, NumResiduals());
  Matrix slopes;
  if (linear_.empty()) {
    sampled_.errors(parameters_, result_, jacobian == nullptr ? nullptr : &slopes);
    result = result_.cwiseProduct(sampled_.roots());
    if (jacobian != nullptr) {
      Eigen::Map<Matrix> columns(jacobian, NumResiduals(), NumParameters());
      columns = columns_of(slopes, nonlinear_, sampled_.roots());
    }
  } else {
    project(result, jacobian);
  }
  if (!result.allFinite()) result.setConstant(HUGE_VAL);  // an infinite cost rejects a step
  return true;
}

void Projection::project(Eigen::Map<Vector>& result, double* jacobian) const {
  for (const std::size_t i : linear_) parameters_[i] = 0;
  Matrix slopes;
  sampled_.errors(parameters_, result_, &slopes);
  const Matrix basis = columns_of(slopes, linear_, sampled_.roots());
  if (!basis.allFinite() || !result_.allFinite()) {
    result.setConstant(HUGE_VAL);
    return;
  }
  const Eigen::ColPivHouseholderQR<Matrix> qr(basis);
  const Vector best = qr.solve(-result_.cwiseProduct(sampled_.roots()));
  for (std::size_t i = 0; i < linear_.size(); ++i)
    parameters_[linear_[i]] = best[static_cast<Eigen::Index>(i)];
  sampled_.errors(parameters_, result_, jacobian == nullptr ? nullptr : &slopes);
  result = result_.cwiseProduct(sampled_.roots());
  if (jacobian == nullptr) return;
  Eigen::Map<Matrix> columns(jacobian, NumResiduals(), NumParameters());
  columns = columns_of(slopes, nonlinear_, sampled_.roots());
  columns -= basis * qr.solve(columns);
}

}  // namespace shadefit
