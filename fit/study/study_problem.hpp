#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "fit/formula/batch.hpp"
#include "fit/steps/sums.hpp"
#include "fit/study/study.hpp"

/// The error of a study as tapes.
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

  const StagedTape& gradient() const { return gradient_; }  ///< the error and its derivatives
  /// and the second derivatives: (0, 0), (1, 0), (1, 1), (2, 0) ..
  const StagedTape& hessian() const { return hessian_; }
  const StagedTape& target() const { return target_; }  ///< what errors are compared with
  /// The denominators of the form that contain a parameter. Where one is 0 the form has a pole.
  const std::vector<StagedTape>& denominators() const { return denominators_; }

 private:
  struct Parts;
  explicit StudyError(Parts parts);

  std::size_t parameter_count_;
  std::vector<bool> is_linear_, is_open_;
  StagedTape gradient_, hessian_, target_;
  std::vector<StagedTape> denominators_;
};

}  // namespace shadefit
