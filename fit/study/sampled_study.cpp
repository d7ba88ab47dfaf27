#include "fit/study/sampled_study.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>

namespace shadefit {
namespace {

template <class T>
std::vector<std::vector<T>> narrowed(const std::vector<std::vector<long double>>& coordinates) {
  std::vector<std::vector<T>> result;
  for (const auto& of_variable : coordinates) result.emplace_back(of_variable.begin(), of_variable.end());
  return result;
}

/// The triangle R of Q R, or what it has of rows.
template <class T>
MatrixOf<T> upper_triangle(const MatrixOf<T>& columns) {
  const Eigen::Index rows = std::min(columns.rows(), columns.cols());
  return Eigen::HouseholderQR<MatrixOf<T>>(columns)
      .matrixQR()
      .topRows(rows)
      .template triangularView<Eigen::Upper>();
}

}  // namespace

template <class T>
SampledStudy<T>::SampledStudy(const StudyError& error, const StudyNodes& nodes, unsigned threads)
    : SampledStudy(error, narrowed<T>(nodes.coordinates), {nodes.weights.begin(), nodes.weights.end()}) {
  rows_ = nodes.rows;
  threads_ = threads;
}

template <class T>
SampledStudy<T> SampledStudy<T>::block(std::size_t number) const {
  if (!rows_) return {*error_, coordinates_, weights_};
  const std::size_t first = number * rows_in_block, count = std::min(rows_in_block, size() - first);
  std::vector<std::vector<T>> coordinates;
  for (const std::vector<double>* column : columns_of(*rows_))
    coordinates.emplace_back(column->data() + first, column->data() + first + count);
  return {*error_, std::move(coordinates), std::vector<T>(count, 1 / static_cast<T>(size()))};
}

template <class T>
VectorOf<T> SampledStudy<T>::roots() const {
  return Eigen::Map<const VectorOf<T>>(weights_.data(), static_cast<Eigen::Index>(weights_.size()))
      .cwiseSqrt();
}

template <class T>
const Batch<T>& SampledStudy<T>::batch(std::optional<Batch<T>>& kept, const StagedTape& tape) const {
  if (!kept) kept.emplace(tape, coordinates_);
  return *kept;
}

template <class T>
T SampledStudy<T>::target_norm() const {
  if (!target_norm_) {
    target_norm_ = std::sqrt(sum_of_blocks([&](std::size_t, const SampledStudy& block) {
      std::vector<S> target;
      Batch<T>(error_->target(), block.coordinates_)(std::vector<T>(count_), target);
      T square = 0;
      for (std::size_t i = 0; i < block.size(); ++i) {
        const T value = block.lane(target, 0, i);
        if (std::isfinite(value))
          square += block.weights_[i] * value * value;  // a residual may overflow there
      }
      return square;
    }));
  }
  return *target_norm_;
}

template <class T>
T SampledStudy<T>::lane(const std::vector<S>& results, std::size_t row, std::size_t node) const {
  constexpr std::size_t lanes = Batch<T>::lanes;
  const std::size_t packs = Batch<T>::packs_of(size());
  return Batch<T>::Lanes::lane(results[row * packs + node / lanes], node % lanes);
}

template <class T>
void SampledStudy<T>::errors(std::span<const T> parameters, VectorOf<T>& errors, MatrixOf<T>* slopes) const {
  errors.resize(static_cast<Eigen::Index>(size()));
  if (slopes != nullptr) slopes->resize(errors.size(), static_cast<Eigen::Index>(count_));
  of_blocks([&](std::size_t number, const SampledStudy& block) {
    std::vector<S> results;
    block.gradient()(parameters, results);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(number * rows_in_block + i);
      errors[row] = block.lane(results, 0, i);
      for (std::size_t j = 0; slopes != nullptr && j < count_; ++j)
        (*slopes)(row, static_cast<Eigen::Index>(j)) = block.lane(results, 1 + j, i);
    }
    return 0;
  });
}

template <class T>
WeightedErrors<T> SampledStudy<T>::reduced(std::span<const T> parameters) const {
  WeightedErrors<T> result;
  if (!rows_) {
    errors(parameters, result.errors, &result.slopes);
    result.roots = roots();
    return result;
  }
  const auto triangles = of_blocks([&](std::size_t, const SampledStudy& block) {
    const WeightedErrors<T> of_block = block.reduced(parameters);
    MatrixOf<T> columns(of_block.slopes.rows(), of_block.slopes.cols() + 1);
    columns << of_block.slopes, of_block.errors;
    return upper_triangle(columns);
  });
  const Eigen::Index n = static_cast<Eigen::Index>(count_) + 1;
  MatrixOf<T> stacked = MatrixOf<T>::Zero(static_cast<Eigen::Index>(triangles.size()) * n, n);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    stacked.middleRows(static_cast<Eigen::Index>(i) * n, triangles[i].rows()) = triangles[i];
  return {stacked.col(n - 1), stacked.leftCols(n - 1),
          VectorOf<T>::Constant(stacked.rows(), std::sqrt(1 / static_cast<T>(size())))};
}

template <>
void SampledStudy<double>::products(std::span<const double> parameters, std::span<const Eigen::Index> columns,
                                    ProductMatrix<double>& result) const {
  if (rows_) {
    result = sum_of_blocks([&](std::size_t, const SampledStudy& block) {
      ProductMatrix<double> of_block;
      block.products(parameters, columns, of_block);
      return of_block;
    });
    return;
  }
  if (packed_weights_.empty()) Batch<double>::append_packed(weights_, 0, packed_weights_);
  constexpr std::size_t most = most_product_columns, parts = WideLoops::group;
  const std::size_t rows = columns.size();
  std::array<TwoLanes, most*(most + 1) / 2 * parts> sums;
  std::fill_n(sums.begin(), rows * (rows + 1) / 2 * parts, TwoLanes(0));
  gradient().visit(parameters, [&](std::size_t first, std::size_t count, std::span<const S* const> outputs) {
    // The error is the first output and the last column.
    std::array<const TwoLanes*, most> of_row;
    for (std::size_t i = 0; i < rows; ++i)
      of_row[i] = outputs[(static_cast<std::size_t>(columns[i]) + 1) % outputs.size()];
    wide_loops().add_products(&packed_weights_[first], std::span(of_row).first(rows), sums.data(),
                              count / parts);
  });
  result.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(rows));
  const TwoLanes* of_entry = sums.data();
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j, of_entry += parts) {
      const TwoLanes sum = (of_entry[0] + of_entry[1]) + (of_entry[2] + of_entry[3]);
      result(i, j) = result(j, i) = sum[0] + sum[1];
    }
  }
}

template <class T>
T SampledStudy<T>::square(std::span<const T> parameters) const {
  return sum_of_blocks([&](std::size_t, const SampledStudy& block) {
    std::vector<S> results;
    block.gradient()(parameters, results);
    T sum = 0;
    for (std::size_t i = 0; i < block.size(); ++i)
      sum += block.weights_[i] * block.lane(results, 0, i) * block.lane(results, 0, i);
    return sum;
  });
}

template <class T>
Sums<T> SampledStudy<T>::gradient(std::span<const T> parameters) const {
  return sum_of_blocks([&](std::size_t, const SampledStudy& block) {
    std::vector<S> results;
    block.gradient()(parameters, results);
    Sums<T> sums{0, ParameterVector<T>::Zero(static_cast<Eigen::Index>(count_)), {}};
    for (std::size_t i = 0; i < block.size(); ++i) {
      const T weighted = block.weights_[i] * block.lane(results, 0, i);
      sums.square += weighted * block.lane(results, 0, i);
      for (std::size_t j = 0; j < count_; ++j)
        sums.gradient[static_cast<Eigen::Index>(j)] += weighted * block.lane(results, 1 + j, i);
    }
    return sums;
  });
}

template <class T>
Sums<T> SampledStudy<T>::derivatives(std::span<const T> parameters) const {
  const auto n = static_cast<Eigen::Index>(count_);
  Sums<T> sums = sum_of_blocks([&](std::size_t, const SampledStudy& block) {
    std::vector<S> results;
    block.hessian()(parameters, results);
    Sums<T> of_block{0, ParameterVector<T>::Zero(n), ParameterMatrix<T>::Zero(n, n)};
    for (std::size_t node = 0; node < block.size(); ++node) {
      const T error = block.lane(results, 0, node), weight = block.weights_[node];
      of_block.square += weight * error * error;
      std::size_t second = 1 + count_;
      for (Eigen::Index i = 0; i < n; ++i) {
        const T slope = block.lane(results, 1 + static_cast<std::size_t>(i), node);
        of_block.gradient[i] += weight * error * slope;
        for (Eigen::Index j = 0; j <= i; ++j) {
          const T other = block.lane(results, 1 + static_cast<std::size_t>(j), node);
          of_block.hessian(i, j) += weight * (slope * other + error * block.lane(results, second++, node));
        }
      }
    }
    return of_block;
  });
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 1; j < n; ++j) sums.hessian(i, j) = sums.hessian(j, i);
  }
  return sums;
}

template <class T>
MatrixOf<T> SampledStudy<T>::curvature(std::span<const T> parameters, std::span<const T> shares) const {
  const auto n = static_cast<Eigen::Index>(count_);
  const MatrixOf<T> sum = sum_of_blocks([&](std::size_t number, const SampledStudy& block) {
    std::vector<S> results;
    block.hessian()(parameters, results);
    MatrixOf<T> of_block = MatrixOf<T>::Zero(n, n);
    for (std::size_t node = 0; node < block.size(); ++node) {
      std::size_t second = 1 + count_;
      for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j)
          of_block(i, j) += shares[number * rows_in_block + node] * block.lane(results, second++, node);
      }
    }
    return of_block;
  });
  return sum.template selfadjointView<Eigen::Lower>();
}

template <class T>
bool SampledStudy<T>::has_pole(std::span<const T> parameters) const {
  struct Sides {
    bool is_positive = false, is_negative = false;
  };
  if (error_->denominators().empty()) return false;
  const auto of_all = of_blocks([&](std::size_t, const SampledStudy& block) {
    for (std::size_t i = block.denominators_.size(); i < error_->denominators().size(); ++i)
      block.denominators_.emplace_back(error_->denominators()[i], block.coordinates_);
    std::vector<Sides> sides;
    std::vector<S> results;
    for (const Batch<T>& denominator : block.denominators_) {
      denominator(parameters, results);
      Sides& own = sides.emplace_back();
      for (std::size_t i = 0; i < block.size(); ++i) {
        const T value = block.lane(results, 0, i);
        own.is_positive = own.is_positive || !(value <= 0);
        own.is_negative = own.is_negative || !(value >= 0);
      }
    }
    return sides;
  });
  for (std::size_t i = 0; i < error_->denominators().size(); ++i) {
    const auto any = [&](bool Sides::*side) {
      return std::ranges::any_of(of_all, [&](const std::vector<Sides>& block) { return block[i].*side; });
    };
    if (any(&Sides::is_positive) == any(&Sides::is_negative)) return true;
  }
  return false;
}

template class SampledStudy<double>;
template class SampledStudy<long double>;

}  // namespace shadefit
