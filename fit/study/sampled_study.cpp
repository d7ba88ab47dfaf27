#include "fit/study/study_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/support/decompositions.hpp"

namespace shadefit {
namespace {

template <class T>
std::vector<std::vector<T>> narrowed(const std::vector<std::vector<long double>>& coordinates) {
  std::vector<std::vector<T>> result;
  for (const auto& of_variable : coordinates) result.emplace_back(of_variable.begin(), of_variable.end());
  return result;
}

/// Calls `work` for the nodes of a batch in their order, with the number of each and what reads its outputs.
template <class T, class Work>
void for_each_node(const Batch<T>& batch, std::span<const T> parameters, const Work& work) {
  constexpr std::size_t lanes = Batch<T>::lanes;
  batch.visit(parameters, [&](std::size_t first, std::size_t count, const auto& outputs) {
    const std::size_t end = std::min((first + count) * lanes, batch.nodes());
    for (std::size_t node = first * lanes; node < end; ++node) {
      const std::size_t pack = node / lanes - first;
      work(node, [&](std::size_t i) -> T { return Batch<T>::Lanes::lane(outputs[i][pack], node % lanes); });
    }
  });
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
  const std::size_t first = number * rows_in_block, count = std::min(rows_in_block, size() - first);
  std::vector<std::vector<T>> coordinates;
  coordinates.reserve(most_axes + 2);
  for (const std::vector<double>* column : columns_of(*rows_))
    coordinates.emplace_back(column->data() + first, column->data() + first + count);
  return {*error_, std::move(coordinates), std::vector<T>(count, 1 / static_cast<T>(size()))};
}

template <class T>
template <class Work>
auto SampledStudy<T>::sum_of_blocks(const Work& work) const {
  if (!rows_) return work(Eigen::Index{0}, *this);
  std::vector<decltype(work(Eigen::Index{0}, *this))> of_blocks(blocks());
  const auto add = [&](std::size_t i, const Checkpoint&) {
    of_blocks[i] = work(static_cast<Eigen::Index>(i * rows_in_block), block(i));
  };
  for_each_in_parallel(of_blocks.size(), add, {.threads = threads_});
  for (std::size_t i = 1; i < of_blocks.size(); ++i) of_blocks.front() += of_blocks[i];
  return of_blocks.front();
}

template <class T>
VectorOf<T> SampledStudy<T>::roots() const {
  const auto count = static_cast<Eigen::Index>(size());
  if (rows_) return VectorOf<T>::Constant(count, std::sqrt(1 / static_cast<T>(size())));
  return Eigen::Map<const VectorOf<T>>(weights_.data(), count).cwiseSqrt();
}

template <class T>
const Batch<T>& SampledStudy<T>::batch(std::optional<Batch<T>>& kept, const StagedTape& tape) const {
  if (!kept) kept.emplace(tape, coordinates_);
  return *kept;
}

template <class T>
T SampledStudy<T>::target_norm() const {
  if (!target_norm_) {
    target_norm_ = std::sqrt(sum_of_blocks([&](Eigen::Index, const SampledStudy& block) {
      T square = 0;
      const std::vector<T> none(count_);
      for_each_node<T>(Batch<T>(error_->target(), block.coordinates_), none,
                       [&](std::size_t node, const auto& output) {
                         const T value = output(0);
                         // A residual may overflow there.
                         if (std::isfinite(value)) square += block.weights_[node] * value * value;
                       });
      return square;
    }));
  }
  return *target_norm_;
}

template <class T>
void SampledStudy<T>::errors(std::span<const T> parameters, VectorOf<T>& errors, MatrixOf<T>* slopes) const {
  errors.resize(static_cast<Eigen::Index>(size()));
  if (slopes != nullptr) slopes->resize(errors.size(), static_cast<Eigen::Index>(count_));
  sum_of_blocks([&](Eigen::Index first, const SampledStudy& block) {
    for_each_node(block.gradient(), parameters, [&](std::size_t node, const auto& output) {
      const Eigen::Index row = first + static_cast<Eigen::Index>(node);
      errors[row] = output(0);
      for (std::size_t j = 0; slopes != nullptr && j < count_; ++j)
        (*slopes)(row, static_cast<Eigen::Index>(j)) = output(1 + j);
    });
    return 0;
  });
}

template <class T>
WeightedErrors<T> SampledStudy<T>::reduced(std::span<const T> parameters) const {
  WeightedErrors<T> all;
  if (!rows_) {
    errors(parameters, all.errors, &all.slopes);
    all.roots = roots();
    return all;
  }
  const auto n = static_cast<Eigen::Index>(count_) + 1;
  MatrixOf<T> triangles = MatrixOf<T>::Zero(static_cast<Eigen::Index>(blocks()) * n, n);
  sum_of_blocks([&](Eigen::Index first, const SampledStudy& block) {
    const WeightedErrors<T> own = block.reduced(parameters);
    MatrixOf<T> columns(own.slopes.rows(), n);
    columns << own.slopes, own.errors;
    const Eigen::Index rows = std::min(columns.rows(), n), at = first / Eigen::Index{rows_in_block} * n;
    const MatrixOf<T> packed = packed_qr(columns).topRows(rows);
    triangles.middleRows(at, rows) = packed.template triangularView<Eigen::Upper>();
    return 0;
  });
  return {triangles.col(n - 1), triangles.leftCols(n - 1),
          VectorOf<T>::Constant(triangles.rows(), std::sqrt(1 / static_cast<T>(size())))};
}

template <>
void SampledStudy<double>::products(std::span<const double> parameters, std::span<const Eigen::Index> columns,
                                    ProductMatrix<double>& result) const {
  if (rows_) {
    result = sum_of_blocks([&](Eigen::Index, const SampledStudy& block) {
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
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t output = static_cast<std::size_t>(columns[i]) + 1;
      of_row[i] = outputs[output < outputs.size() ? output : 0];
    }
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
Sums<T> SampledStudy<T>::gradient(std::span<const T> parameters) const {
  return sum_of_blocks([&](Eigen::Index, const SampledStudy& block) {
    Sums<T> sums{0, ParameterVector<T>::Zero(static_cast<Eigen::Index>(count_)), {}};
    for_each_node(block.gradient(), parameters, [&](std::size_t node, const auto& output) {
      const T error = output(0), weighted = block.weights_[node] * error;
      sums.square += weighted * error;
      for (std::size_t j = 0; j < count_; ++j)
        sums.gradient[static_cast<Eigen::Index>(j)] += weighted * output(1 + j);
    });
    return sums;
  });
}

template <class T>
Sums<T> SampledStudy<T>::derivatives(std::span<const T> parameters) const {
  const auto n = static_cast<Eigen::Index>(count_);
  Sums<T> sums = sum_of_blocks([&](Eigen::Index, const SampledStudy& block) {
    Sums<T> of_block{0, ParameterVector<T>::Zero(n), ParameterMatrix<T>::Zero(n, n)};
    std::array<T, most_study_parameters> slopes;
    for_each_node(block.hessian(), parameters, [&](std::size_t node, const auto& output) {
      const T error = output(0), weight = block.weights_[node];
      of_block.square += weight * error * error;
      for (std::size_t i = 0; i < count_; ++i) slopes[i] = output(1 + i);
      std::size_t second = 1 + count_;
      for (std::size_t i = 0; i < count_; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        of_block.gradient[row] += weight * error * slopes[i];
        for (std::size_t j = 0; j <= i; ++j)
          of_block.hessian(row, static_cast<Eigen::Index>(j)) +=
              weight * (slopes[i] * slopes[j] + error * output(second++));
      }
    });
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
  const MatrixOf<T> sum = sum_of_blocks([&](Eigen::Index first, const SampledStudy& block) {
    MatrixOf<T> of_block = MatrixOf<T>::Zero(n, n);
    for_each_node(block.hessian(), parameters, [&](std::size_t node, const auto& output) {
      const T share = shares[static_cast<std::size_t>(first) + node];
      std::size_t second = 1 + count_;
      for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) of_block(i, j) += share * output(second++);
      }
    });
    return of_block;
  });
  return sum.template selfadjointView<Eigen::Lower>();
}

template <class T>
bool SampledStudy<T>::has_pole(std::span<const T> parameters) const {
  const std::vector<StagedTape>& all = error_->denominators();
  if (all.empty()) return false;
  // How many nodes are on each side of 0.
  const MatrixOf<double> sides = sum_of_blocks([&](Eigen::Index, const SampledStudy& block) {
    MatrixOf<double> of_block = MatrixOf<double>::Zero(2, static_cast<Eigen::Index>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (block.denominators_.size() == i) block.denominators_.emplace_back(all[i], block.coordinates_);
      auto own = of_block.col(static_cast<Eigen::Index>(i));
      for_each_node(block.denominators_[i], parameters, [&](std::size_t, const auto& output) {
        const T value = output(0);
        own[0] += value <= 0 ? 0 : 1;
        own[1] += value >= 0 ? 0 : 1;
      });
    }
    return of_block;
  });
  return ((sides.row(0).array() > 0) == (sides.row(1).array() > 0)).any();
}

template class SampledStudy<double>;
template class SampledStudy<long double>;

}  // namespace shadefit
