#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "fit/steps/sums.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/parallel.hpp"

/// Sums of the error of a study over nodes.
namespace shadefit {

/// Errors, a column of their derivatives for each parameter, and the roots of their weights.
template <class T>
struct WeightedErrors {
  VectorOf<T> errors;
  MatrixOf<T> slopes;
  VectorOf<T> roots;
};

/// The error at nodes. One thread uses it at a time. Nodes that are rows without a copy are computed in
/// blocks on all cores, and nothing of them is kept. A sum is that of the blocks in their order, so it does
/// not depend on the number of threads.
template <class T>
class SampledStudy {
 public:
  /// Keeps a pointer to the error.
  SampledStudy(const StudyError& error, const StudyNodes& nodes, unsigned threads = cores());

  std::size_t size() const { return rows_ ? rows_->value.size() : weights_.size(); }
  std::size_t parameter_count() const { return count_; }
  /// sqrt(weight) of each node.
  VectorOf<T> roots() const;

  static constexpr std::size_t rows_in_block = 4096;

  /// The results of `work` for each block, in their order. It gets the number of a block, and its nodes.
  template <class Work>
  auto of_blocks(const Work& work) const {
    using Result = std::invoke_result_t<const Work&, std::size_t, const SampledStudy&>;
    if (!rows_) return std::vector<Result>{work(std::size_t{0}, *this)};
    std::vector<Result> results((size() + rows_in_block - 1) / rows_in_block);
    for_each_in_parallel(results.size(),
                         [&](std::size_t i, const Checkpoint&) { results[i] = work(i, block(i)); },
                         {.threads = threads_});
    return results;
  }
  /// The nodes of one block. There is more than one if these are rows without a copy.
  SampledStudy block(std::size_t number) const;

  /// What a decomposition needs of the errors: those at the nodes, or of several blocks triangles with the
  /// same sums of squares and of products.
  WeightedErrors<T> reduced(std::span<const T> parameters) const;

  /// The errors at the nodes, and if `slopes` is not null a column of their derivatives for each parameter.
  void errors(std::span<const T> parameters, VectorOf<T>& errors, MatrixOf<T>* slopes) const;

  /// The sums of weight * u * v over the nodes, for u and v of these columns. Column i is the derivative by
  /// parameter i; the column after the last parameter is the error. In double only.
  void products(std::span<const T> parameters, std::span<const Eigen::Index> columns,
                ProductMatrix<T>& result) const;

  T square(std::span<const T> parameters) const;
  /// Without the Hessian.
  Sums<T> gradient(std::span<const T> parameters) const;
  Sums<T> derivatives(std::span<const T> parameters) const;
  /// The sum of share * (second derivatives of the error) over the nodes, with a share for each.
  MatrixOf<T> curvature(std::span<const T> parameters, std::span<const T> shares) const;

  /// The root mean square of the error of a form that is 0: the scale of the problem.
  T target_norm() const;

  /// Whether a denominator of the form vanishes or changes its sign between nodes.
  bool has_pole(std::span<const T> parameters) const;

 private:
  using S = typename Batch<T>::S;

  SampledStudy(const StudyError& error, std::vector<std::vector<T>> coordinates, std::vector<T> weights)
      : error_(&error),
        count_(error.parameter_count()),
        coordinates_(std::move(coordinates)),
        weights_(std::move(weights)) {}

  /// The sum of the results for all blocks.
  template <class Work>
  auto sum_of_blocks(const Work& work) const {
    auto results = of_blocks(work);
    for (std::size_t i = 1; i < results.size(); ++i) results.front() += results[i];
    return std::move(results.front());
  }
  T lane(const std::vector<S>& results, std::size_t row, std::size_t node) const;
  const Batch<T>& batch(std::optional<Batch<T>>& kept, const StagedTape& tape) const;
  const Batch<T>& gradient() const { return batch(gradient_, error_->gradient()); }
  const Batch<T>& hessian() const { return batch(hessian_, error_->hessian()); }

  const StudyError* error_;
  std::size_t count_;
  std::shared_ptr<const MeasuredRows> rows_ = nullptr;  ///< then both lists are empty
  unsigned threads_ = 1;
  std::vector<std::vector<T>> coordinates_;
  std::vector<T> weights_;
  // When first needed: many rules are only for the errors.
  mutable std::optional<Batch<T>> gradient_ = {}, hessian_ = {};
  mutable std::vector<S> packed_weights_ = {};  ///< 0 for a node that is repeated
  mutable std::vector<Batch<T>> denominators_ = {};
  mutable std::optional<T> target_norm_ = {};
};

template <>
void SampledStudy<double>::products(std::span<const double> parameters, std::span<const Eigen::Index> columns,
                                    ProductMatrix<double>& result) const;

extern template class SampledStudy<double>;
extern template class SampledStudy<long double>;

}  // namespace shadefit
