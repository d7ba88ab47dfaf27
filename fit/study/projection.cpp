#include "fit/study/projection.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Matrix = MatrixOf<double>;
using Triangle = ProductMatrix<double>;

/// The linear parameters need not reduce the square by less than this share.
constexpr double small_share = 1e-10;

/// Turns the upper half of a symmetric A into the triangle R with R^T R = A, by Cholesky. False if a column
/// is so close to a combination of the earlier ones that its rest loses more than half of its digits.
bool factorise_in_place(Triangle& a) {
  constexpr double independent = 1e-8;
  const Eigen::Index n = a.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    double rest = a(i, i);
    for (Eigen::Index k = 0; k < i; ++k) rest -= a(k, i) * a(k, i);
    // The rest of the last column, the error, counts however small it is.
    const bool is_error = i + 1 == n;
    const bool is_empty = a(i, i) == 0;  // such as that of a nonlinear parameter while the linear ones are 0
    if (!is_error && !is_empty && !(rest > independent * a(i, i))) return false;
    const double root = is_empty ? 0 : std::sqrt(std::max(0.0, rest));
    a(i, i) = root;
    for (Eigen::Index j = i + 1; j < n; ++j) {
      double product = a(i, j);
      for (Eigen::Index k = 0; k < i; ++k) product -= a(k, i) * a(k, j);
      a(i, j) = root == 0 ? 0 : product / root;
    }
  }
  for (Eigen::Index j = 0; j < n; ++j) std::fill_n(&a(0, j) + j + 1, n - j - 1, 0.0);
  return true;
}

/// The same triangle by Householder reflections. The columns are sqrt(weight) * derivative, the last one is
/// the error.
Triangle triangle_of(const Matrix& slopes, const VectorOf<double>& errors, const VectorOf<double>& roots) {
  Matrix columns(slopes.rows(), slopes.cols() + 1);
  columns << slopes, errors;
  columns = roots.asDiagonal() * columns;
  const Eigen::Index n = columns.cols();
  if (columns.rows() < n) columns.conservativeResizeLike(Matrix::Zero(n, n));
  return packed_qr(columns).topRows(n).triangularView<Eigen::Upper>();
}

/// The solution x of R x = right, for the first rows of R. An empty column gets 0.
ProductVector<double> solved(const Triangle& triangle, const ProductVector<double>& right) {
  ProductVector<double> x = ProductVector<double>::Zero(right.size());
  for (Eigen::Index i = right.size(); i-- > 0;) {
    const Eigen::Index rest = right.size() - 1 - i;
    const double known = triangle.row(i).segment(i + 1, rest).dot(x.tail(rest));
    if (triangle(i, i) != 0) x[i] = (right[i] - known) / triangle(i, i);
  }
  return x;
}

}  // namespace

Projection::Projection(const StudyError& error, const SampledStudy<double>& sampled,
                       std::optional<std::size_t> held)
    : sampled_(sampled), held_(held) {
  last_.parameters.resize(error.parameter_count());
  for (std::size_t i = 0; i < error.parameter_count(); ++i) {
    if (i != held) (error.is_linear()[i] ? linear_ : nonlinear_).push_back(i);
  }
  const auto error_column = static_cast<Eigen::Index>(error.parameter_count());
  linear_columns_.assign(linear_.begin(), linear_.end());
  columns_ = linear_columns_;
  columns_.insert(columns_.end(), nonlinear_.begin(), nonlinear_.end());
  linear_columns_.push_back(error_column);
  columns_.push_back(error_column);
}

void Projection::keep(std::vector<double>& numbers) const {
  const Triangle& triangle = last_.triangle;
  numbers.insert(numbers.end(), last_.parameters.begin(), last_.parameters.end());
  numbers.insert(numbers.end(), triangle.data(), triangle.data() + triangle.size());
}

void Projection::recall(std::span<const double> numbers) const {
  const auto size = static_cast<Eigen::Index>(columns_.size());
  std::copy_n(numbers.begin(), last_.parameters.size(), last_.parameters.begin());
  last_.triangle = Eigen::Map<const Matrix>(&numbers[last_.parameters.size()], size, size);
  last_.is_known = true;
  accepted_.is_known = false;
}

bool Projection::is_at(const Point& point, const double* q) const {
  const auto is_equal = [&](std::size_t i, double value) { return point.parameters[i] == value; };
  return point.is_known && std::equal(nonlinear_.begin(), nonlinear_.end(), q, is_equal);
}

bool Projection::factorise(std::span<const Eigen::Index> columns) const {
  sampled_.products(last_.parameters, columns, last_.triangle);
  if (!last_.triangle.allFinite()) {
    last_.triangle.setConstant(HUGE_VAL);
    return false;
  }
  if (factorise_in_place(last_.triangle)) return true;
  const WeightedErrors<double> all = sampled_.reduced(last_.parameters);
  const std::vector<Eigen::Index> of_slopes(columns.begin(), columns.end() - 1);
  last_.triangle = triangle_of(all.slopes(Eigen::all, of_slopes), all.errors, all.roots);
  return false;
}

bool Projection::follow(const double* q) const {
  // The largest allowed distance of the linear parameters from their best, as a share of the square. It does
  // not affect the residuals, because R removes it from them; a share of half costs a bit. It affects the
  // derivatives if a step is long. Towards the end of a descent the share is of the order of the fourth power
  // of a step.
  constexpr double nearly = 0.1, half = 0.5;
  const auto count = static_cast<Eigen::Index>(linear_.size());
  ProductVector<double> right = ProductVector<double>::Zero(count);
  for (std::size_t i = 0; i < nonlinear_.size(); ++i) {
    const auto column = accepted_.triangle.col(count + static_cast<Eigen::Index>(i));
    right += column.head(count) * (q[i] - accepted_.parameters[nonlinear_[i]]);
  }
  const ProductVector<double> step = solved(accepted_.triangle, right);
  for (std::size_t i = 0; i < linear_.size(); ++i)
    last_.parameters[linear_[i]] = accepted_.parameters[linear_[i]] - step[static_cast<Eigen::Index>(i)];
  if (!factorise(columns_) || !(linear_share() < half)) return false;
  if (linear_share() > nearly) {
    move_linear();
    if (!factorise(columns_)) return false;
  }
  move_linear();
  last_.triangle.rightCols(1).topRows(count).setZero();
  return true;
}

void Projection::move_to(const double* q) const {
  for (std::size_t i = 0; i < nonlinear_.size(); ++i) last_.parameters[nonlinear_[i]] = q[i];
  if (accepted_.is_known && !linear_.empty() && follow(q)) return;
  // First the linear parameters alone, then all. One step is enough, unless the linear columns are nearly
  // dependent.
  for (const std::size_t i : linear_) last_.parameters[i] = 0;
  if (!linear_.empty()) {
    factorise(linear_columns_);
    if (linear_share() > small_share) move_linear();
  }
  factorise(columns_);
  constexpr int most_linear_steps = 2;
  for (int i = 0; i < most_linear_steps && linear_share() > small_share; ++i) {
    move_linear();
    factorise(columns_);
  }
}

double Projection::linear_share() const {
  if (linear_.empty()) return 0;
  const auto errors = last_.triangle.col(last_.triangle.cols() - 1);
  const double square = errors.squaredNorm();
  return square > 0 ? errors.head(static_cast<Eigen::Index>(linear_.size())).squaredNorm() / square : 0;
}

/// Moves the linear parameters to their best: R_LL step = -R_Lr.
void Projection::move_linear() const {
  const auto count = static_cast<Eigen::Index>(linear_.size());
  const ProductVector<double> right = last_.triangle.col(last_.triangle.cols() - 1).head(count);
  const ProductVector<double> step = solved(last_.triangle, right);
  for (std::size_t i = 0; i < linear_.size(); ++i)
    last_.parameters[linear_[i]] -= step[static_cast<Eigen::Index>(i)];
}

void Projection::operator()(const double* q, double* residuals, double* jacobian) const {
  if (!is_at(last_, q)) {
    if (is_at(accepted_, q)) {
      last_ = accepted_;
    } else {
      move_to(q);
    }
  }
  last_.is_known = true;
  const Eigen::Index n = unknown_count();
  Eigen::Map<VectorOf<double>> result(residuals, n + 1);
  const auto errors = last_.triangle.col(last_.triangle.cols() - 1);
  result = errors.tail(n + 1);
  // All of the square counts, with the part that the linear parameters could not remove.
  if (!linear_.empty()) result[n] = std::hypot(result[n], errors.head(errors.size() - n - 1).norm());
  if (jacobian != nullptr) {
    accepted_ = last_;
    Eigen::Map<Matrix> columns(jacobian, n + 1, n);
    columns = last_.triangle.bottomRows(n + 1).rightCols(n + 1).leftCols(n);
  }
  if (!result.allFinite()) result.setConstant(HUGE_VAL);  // an infinite cost rejects a step
}

}  // namespace shadefit
