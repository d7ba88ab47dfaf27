#include "fit/study/projection.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace shadefit {
namespace {

using Matrix = MatrixOf<double>;
using Triangle = ProductMatrix<double>;

/// A share of the square that the linear parameters need not take away.
constexpr double small_share = 1e-10;

/// The upper triangle R with R^T R = A, by Cholesky. Empty if a column is so near to a combination of those
/// before it that more than half of the digits of what is left are lost.
std::optional<Triangle> triangle_of(const Triangle& a) {
  constexpr double independent = 1e-8;
  const Eigen::Index n = a.rows();
  Triangle r = Triangle::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double rest = a(i, i) - r.col(i).head(i).squaredNorm();
    // What is left of the last column, the error, counts however small it is.
    const bool is_error = i + 1 == n;
    if (a(i, i) == 0) continue;  // as that of a nonlinear parameter while the linear ones are 0
    if (!is_error && !(rest > independent * a(i, i))) return std::nullopt;
    const double root = std::sqrt(std::max(0.0, rest));
    r(i, i) = root;
    for (Eigen::Index j = i + 1; j < n; ++j)
      r(i, j) = (a(i, j) - r.col(i).head(i).dot(r.col(j).head(i))) / root;
  }
  return r;
}

/// The same triangle by reflections of the columns of sqrt(weight) * derivative, and of the error as the
/// last.
Triangle triangle_of(const Matrix& slopes, const VectorOf<double>& errors, const VectorOf<double>& roots) {
  Matrix columns(slopes.rows(), slopes.cols() + 1);
  columns << slopes, errors;
  columns = roots.asDiagonal() * columns;
  const Eigen::Index n = columns.cols();
  if (columns.rows() < n) columns.conservativeResizeLike(Matrix::Zero(n, n));
  const Eigen::HouseholderQR<Matrix> qr(columns);
  return qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
}

}  // namespace

Projection::Projection(const StudyError& error, const SampledStudy<double>& sampled,
                       std::optional<std::size_t> held)
    : sampled_(sampled), held_(held), parameters_(error.parameter_count()) {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (i != held) (error.is_linear()[i] ? linear_ : nonlinear_).push_back(i);
  }
  order_.assign(linear_.begin(), linear_.end());
  order_.insert(order_.end(), nonlinear_.begin(), nonlinear_.end());
  order_.push_back(static_cast<Eigen::Index>(parameters_.size()));
}

void Projection::factorise() const {
  const Triangle products = sampled_.products(parameters_);
  if (!products.allFinite()) {
    triangle_.setConstant(products.rows(), products.cols(), HUGE_VAL);
  } else if (auto triangle = triangle_of(products(order_, order_))) {
    triangle_ = *std::move(triangle);
  } else {
    VectorOf<double> errors;
    Matrix slopes;
    sampled_.errors(parameters_, errors, &slopes);
    const std::vector<Eigen::Index> columns(order_.begin(), order_.end() - 1);
    triangle_ = triangle_of(slopes(Eigen::all, columns), errors, sampled_.roots());
  }
}

void Projection::move_to(const double* q) const {
  for (std::size_t i = 0; i < nonlinear_.size(); ++i) parameters_[nonlinear_[i]] = q[i];
  for (const std::size_t i : linear_) parameters_[i] = 0;
  factorise();
  // One step is enough, unless the linear columns are nearly dependent.
  constexpr int most_steps = 3;
  for (int i = 0; i < most_steps && linear_share() > small_share; ++i) {
    move_linear();
    factorise();
  }
}

double Projection::linear_share() const {
  const auto errors = triangle_.col(triangle_.cols() - 1);
  const double square = errors.squaredNorm();
  return square > 0 ? errors.head(static_cast<Eigen::Index>(linear_.size())).squaredNorm() / square : 0;
}

/// The step of the linear parameters to their best: R_LL step = -R_Lr.
void Projection::move_linear() const {
  const auto count = static_cast<Eigen::Index>(linear_.size());
  ProductVector<double> step = ProductVector<double>::Zero(count);
  for (Eigen::Index i = count; i-- > 0;) {
    const double right =
        triangle_(i, triangle_.cols() - 1) + triangle_.row(i).segment(i, count - i).dot(step.tail(count - i));
    if (triangle_(i, i) != 0) step[i] = -right / triangle_(i, i);
  }
  for (std::size_t i = 0; i < linear_.size(); ++i)
    parameters_[linear_[i]] += step[static_cast<Eigen::Index>(i)];
}

bool Projection::operator()(const double* q, double* residuals, double* jacobian) const {
  const auto is_equal = [&](std::size_t i, double value) { return parameters_[i] == value; };
  is_at_place_ = is_at_place_ && std::equal(nonlinear_.begin(), nonlinear_.end(), q, is_equal);
  if (!is_at_place_) move_to(q);
  is_at_place_ = true;
  const Eigen::Index n = NumParameters();
  Eigen::Map<VectorOf<double>> result(residuals, n + 1);
  const auto errors = triangle_.col(triangle_.cols() - 1);
  result = errors.tail(n + 1);
  // All of the square counts, also what the linear parameters could not take away.
  result[n] = std::hypot(result[n], errors.head(errors.size() - n - 1).norm());
  if (jacobian != nullptr) {
    Eigen::Map<Matrix> columns(jacobian, n + 1, n);
    columns = triangle_.bottomRows(n + 1).rightCols(n + 1).leftCols(n);
  }
  if (!result.allFinite()) result.setConstant(HUGE_VAL);  // an infinite cost rejects a step
  return true;
}

}  // namespace shadefit
