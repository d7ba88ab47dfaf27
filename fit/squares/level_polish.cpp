#include "fit/squares/level_polish.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "fit/steps/digits.hpp"
#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

using Vector = VectorOf<double>;
using Matrix = MatrixOf<double>;

StudyNodes nodes_of_level(const StudyNodes& all, const std::vector<LevelRow>& rows) {
  StudyNodes nodes;
  for (const auto& column : all.coordinates) {
    std::vector<long double> of_rows;
    for (const LevelRow& row : rows) of_rows.push_back(column[row.row]);
    nodes.coordinates.push_back(std::move(of_rows));
  }
  nodes.weights.assign(rows.size(), 1.0L / static_cast<long double>(rows.size()));
  return nodes;
}

class LevelSystem {
 public:
  LevelSystem(const LevelPoints& points, const Matrix& steps, double unit, PolishedLevel& at)
      : points_(points),
        steps_(steps),
        unit_(unit),
        at_(at),
        directions_(steps.cols()),
        rows_(static_cast<Eigen::Index>(at.rows.size())) {}

  /// Newton's steps in double. False if they do not become small.
  bool descend() {
    constexpr int most_passes = 30;
    // Steps are in units in which 1 changes the errors by the level.
    constexpr double far = 1e3, small = 1e-12, nearly = 1e-6;
    double last = HUGE_VAL;
    for (int pass = 0; pass < most_passes; ++pass) {
      const double size = move<double>(points_.errors);
      if (!(size <= far)) return false;
      if (size <= small || (size <= nearly && size >= last / 2)) return true;
      last = size;
    }
    return false;
  }

  /// Two more, with residuals in long double. The last one gives the digits.
  bool finish() {
    for (int pass = 0; pass < 2; ++pass) {
      if (!std::isfinite(move<long double>(points_.wide))) return false;
    }
    at_.digits = correct_digits(relative_);
    at_.bend = bend();
    return true;
  }

 private:
  /// The slopes of sign * error along the directions, in units of the level.
  Matrix signed_slopes() const {
    Vector errors;
    Matrix slopes;
    points_.errors(at_.parameters, errors, slopes);
    for (Eigen::Index i = 0; i < rows_; ++i) slopes.row(i) *= row(i).sign / unit_;
    return slopes * steps_;
  }

  Matrix curvature() const {
    std::vector<double> shares;
    for (const LevelRow& one : at_.rows) shares.push_back(one.multiplier * one.sign / unit_);
    return points_.curvature(at_.parameters, shares, steps_);
  }

  LevelRow& row(Eigen::Index i) { return at_.rows[static_cast<std::size_t>(i)]; }
  const LevelRow& row(Eigen::Index i) const { return at_.rows[static_cast<std::size_t>(i)]; }

  /// The residuals of the equations, in arithmetic T.
  template <class T, class Errors>
  Vector residuals(const Errors& errors_at) const {
    const std::vector<T> parameters(at_.parameters.begin(), at_.parameters.end());
    VectorOf<T> errors;
    MatrixOf<T> slopes;
    errors_at(parameters, errors, slopes);
    VectorOf<T> gradient = VectorOf<T>::Zero(slopes.cols());
    Vector result(directions_ + 1 + rows_);
    T sum = -1;
    for (Eigen::Index i = 0; i < rows_; ++i) {
      const T sign = static_cast<T>(row(i).sign);
      gradient += static_cast<T>(row(i).multiplier) * sign * slopes.row(i).transpose();
      if (!row(i).held) sum += static_cast<T>(row(i).multiplier);
      const T level = static_cast<T>(row(i).held.value_or(at_.level));
      result[directions_ + 1 + i] = static_cast<double>((sign * errors[i] - level) / static_cast<T>(unit_));
    }
    result.head(directions_) =
        steps_.transpose() * (gradient / static_cast<T>(unit_)).template cast<double>();
    result[directions_] = static_cast<double>(sum);
    return result;
  }

  /// Takes one step. Returns its size, or NaN.
  template <class T, class Errors>
  double move(const Errors& errors_at) {
    const Eigen::Index unknowns = directions_ + 1 + rows_;
    const Matrix slopes = signed_slopes();
    Matrix matrix = Matrix::Zero(unknowns, unknowns);
    matrix.topLeftCorner(directions_, directions_) = curvature();
    matrix.topRightCorner(directions_, rows_) = slopes.transpose();
    matrix.bottomLeftCorner(rows_, directions_) = slopes;
    for (Eigen::Index i = 0; i < rows_; ++i) {
      if (row(i).held) continue;
      matrix(directions_, directions_ + 1 + i) = 1;
      matrix(directions_ + 1 + i, directions_) = -1;
    }
    if (!matrix.allFinite()) return NAN;
    // If the level leaves some steps undetermined, the shortest one is taken.
    constexpr double rounding = 1e-11;
    const Vector step = -shortest_solution(matrix, residuals<T>(errors_at), rounding);
    const Vector moved = steps_ * step.head(directions_);
    relative_ = 0;
    for (std::size_t j = 0; j < at_.parameters.size(); ++j) {
      const double by = moved[static_cast<Eigen::Index>(j)];
      const double least = 1e-3 * steps_.row(static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
      relative_ = std::max(relative_, std::abs(by) / std::max(std::abs(at_.parameters[j]), least));
      at_.parameters[j] += by;
    }
    at_.level += unit_ * step[directions_];
    for (Eigen::Index i = 0; i < rows_; ++i) row(i).multiplier += step[directions_ + 1 + i];
    return step.allFinite() ? step.head(directions_).cwiseAbs().maxCoeff() : NAN;
  }

  double bend() const {
    constexpr double rounding =
        1e-9;  // of the steps: the optimum makes one slope a combination of the others
    const PivotedQr qr = pivoted_qr(signed_slopes().transpose(), rounding);
    const Eigen::Index free = directions_ - qr.rank();
    if (free <= 0) return HUGE_VAL;
    const Matrix along = basis(qr).rightCols(free);
    return eigen_of(along.transpose() * curvature() * along).eigenvalues()[0];
  }

  const LevelPoints& points_;
  const Matrix& steps_;
  double unit_;
  PolishedLevel& at_;
  Eigen::Index directions_, rows_;
  double relative_ = 0;
};

}  // namespace

LevelPoints points_of_rows(const StudyError& error, const StudyNodes& all_rows,
                           const std::vector<LevelRow>& rows) {
  const StudyNodes nodes = nodes_of_level(all_rows, rows);
  const auto sampled = std::make_shared<SampledStudy<double>>(error, nodes);
  const auto wide = std::make_shared<SampledStudy<long double>>(error, nodes);
  return {[sampled](std::span<const double> parameters, Vector& errors, Matrix& slopes) {
            sampled->errors(parameters, errors, &slopes);
          },
          [wide](std::span<const long double> parameters, VectorOf<long double>& errors,
                 MatrixOf<long double>& slopes) { wide->errors(parameters, errors, &slopes); },
          [sampled](std::span<const double> parameters, std::span<const double> shares, const Matrix& steps)
              -> Matrix { return steps.transpose() * sampled->curvature(parameters, shares) * steps; }};
}

std::optional<PolishedLevel> polish_level(const LevelPoints& points, const MatrixOf<double>& steps,
                                          std::vector<double> parameters, double level,
                                          std::vector<LevelRow> rows) {
  PolishedLevel polished{std::move(parameters), level, std::move(rows)};
  LevelSystem system(points, steps, level, polished);
  if (!system.descend() || !system.finish()) return std::nullopt;
  constexpr double rounding = 1e-9;  // of a multiplier that is 0
  for (const LevelRow& row : polished.rows)
    if (!row.held && !(row.multiplier >= -rounding)) return std::nullopt;
  return polished;
}

}  // namespace shadefit
