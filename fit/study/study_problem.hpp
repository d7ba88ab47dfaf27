#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fit/formula/batch.hpp"
#include "fit/steps/sums.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/support/parallel.hpp"

/// The error of a study as tapes, and its sums over nodes.
namespace shadefit {

template <class T>
using VectorOf = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using MatrixOf = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// The parameters behind a step, added in its arithmetic.
template <class T>
std::vector<double> moved_by(const VectorOf<T>& step, std::vector<double> parameters) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parameters[i] = static_cast<double>(static_cast<T>(parameters[i]) + step[static_cast<Eigen::Index>(i)]);
  return parameters;
}

/// The parameters and the error of a study. The products of these columns lie on the stack.
inline constexpr int most_product_columns = static_cast<int>(most_study_parameters) + 1;
template <class T>
using ProductMatrix =
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, most_product_columns, most_product_columns>;
template <class T>
using ProductVector = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, most_product_columns, 1>;

/// weight * (form - target), divided by the target if the error is relative.
Symbolic error_formula(const ReadStudy& study);

/// The factor of form - target in that error.
Symbolic error_factor(const ReadStudy& study);

/// The error of a study with its derivatives by the parameters. Its integrals are computed by `rule`.
class StudyError {
 public:
  explicit StudyError(const ReadStudy& study, IntegralRule rule = IntegralRule::usual);

  std::size_t parameter_count() const { return parameter_count_; }
  /// For each parameter whether it is marked. The form is linear in all marked parameters together.
  const std::vector<bool>& is_linear() const { return is_linear_; }

  /// For each parameter whether the derivative by it is 0 for all values.
  const std::vector<bool>& is_open() const { return is_open_; }

  const StagedTape& gradient() const { return *gradient_; }  ///< the error and its derivatives
  /// and the second derivatives: (0, 0), (1, 0), (1, 1), (2, 0) ..
  const StagedTape& hessian() const { return *hessian_; }
  const StagedTape& target() const { return *target_; }  ///< what errors are compared with
  /// The denominators of the form that contain a parameter. Where one is 0 the form has a pole.
  const std::vector<StagedTape>& denominators() const { return denominators_; }

 private:
  std::size_t parameter_count_;
  std::vector<bool> is_linear_, is_open_;
  std::optional<StagedTape> gradient_, hessian_, target_;
  std::vector<StagedTape> denominators_;
};

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

  /// What a decomposition needs of the errors: those at the nodes, or of several blocks triangles with the
  /// same sums of squares and of products.
  WeightedErrors<T> reduced(std::span<const T> parameters) const;

  /// The errors at the nodes, and if `slopes` is not null a column of their derivatives for each parameter.
  void errors(std::span<const T> parameters, VectorOf<T>& errors, MatrixOf<T>* slopes) const;

  /// The sums of weight * u * v over the nodes, for u and v of these columns. Column i is the derivative by
  /// parameter i; the column after the last parameter is the error. In double only.
  void products(std::span<const T> parameters, std::span<const Eigen::Index> columns,
                ProductMatrix<T>& result) const;

  T square(std::span<const T> parameters) const { return gradient(parameters).square; }
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

  static constexpr std::size_t rows_in_block = 4096;

  std::size_t blocks() const { return rows_ ? (size() + rows_in_block - 1) / rows_in_block : 1; }
  SampledStudy block(std::size_t number) const;
  /// The sum of what `work` returns for each block. It gets the number of the first node, and the nodes.
  template <class Work>
  auto sum_of_blocks(const Work& work) const;
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
