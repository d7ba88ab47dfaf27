#include "fit/study/projection.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

namespace shadefit {
namespace {

using Matrix = MatrixOf<double>;
using Triangle = ProductMatrix<double>;

/// A share of the square that the linear parameters need not take away.
constexpr double small_share = 1e-10;

/// Makes of the upper half of a symmetric A the triangle R with R^T R = A, by Cholesky. False if a column is
/// so near to a combination of those before it that more than half of the digits of what is left are lost.
bool factorise_in_place(Triangle& a) {
  constexpr double independent = 1e-8;
  const Eigen::Index n = a.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    double rest = a(i, i);
    for (Eigen::Index k = 0; k < i; ++k) rest -= a(k, i) * a(k, i);
    // What is left of the last column, the error, counts however small it is.
    const bool is_error = i + 1 == n;
    const bool is_empty = a(i, i) == 0;  // as that of a nonlinear parameter while the linear ones are 0
    if (!is_error && !is_empty && !(rest > independent * a(i, i))) return false;
    const double root = is_empty ? 0 : std::sqrt(std::max(0.0, rest));
    a(i, i) = root;
    for (Eigen::Index j = i + 1; j < n; ++j) {
      double product = a(i, j);
      for (Eigen::Index k = 0; k < i; ++k) product -= a(k, i) * a(k, j);
      a(i, j) = root == 0 ? 0 : product / root;
    }
  }
  a.triangularView<Eigen::StrictlyLower>().setZero();
  return true;
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
  const auto error_column = static_cast<Eigen::Index>(parameters_.size());
  linear_columns_.assign(linear_.begin(), linear_.end());
  columns_ = linear_columns_;
  columns_.insert(columns_.end(), nonlinear_.begin(), nonlinear_.end());
  linear_columns_.push_back(error_column);
  columns_.push_back(error_column);
}

void Projection::factorise(std::span<const Eigen::Index> columns) const {
  sampled_.products(parameters_, columns, triangle_);
  if (!triangle_.allFinite()) {
    triangle_.setConstant(HUGE_VAL);
  } else if (!factorise_in_place(triangle_)) {
    VectorOf<double> errors;
    Matrix slopes;
    sampled_.errors(parameters_, errors, &slopes);
    const std::vector<Eigen::Index> of_slopes(columns.begin(), columns.end() - 1);
    triangle_ = triangle_of(slopes(Eigen::all, of_slopes), errors, sampled_.roots());
  }
}

void Projection::move_to(const double* q) const {
  for (std::size_t i = 0; i < nonlinear_.size(); ++i) parameters_[nonlinear_[i]] = q[i];
  for (const std::size_t i : linear_) parameters_[i] = 0;
  // The linear parameters alone, then all. One step is enough, unless the linear columns are nearly
  // dependent.
  if (!linear_.empty()) {
    factorise(linear_columns_);
    if (linear_share() > small_share) move_linear();
  }
  factorise(columns_);
  constexpr int most_steps = 2;
  for (int i = 0; i < most_steps && linear_share() > small_share; ++i) {
    move_linear();
    factorise(columns_);
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
