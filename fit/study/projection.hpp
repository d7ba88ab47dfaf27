#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/study/study_problem.hpp"

/// Least squares without the parameters that enter linearly.
namespace shadefit {

/// The reduced problem of variable projection, for ceres::TinySolver: its unknowns are the parameters that do
/// not enter linearly, the others are the best for them. One parameter may be held.
///
/// With J the derivatives and r the errors, times the roots of the weights, one per node, a triangle R with
/// R^T R = [J r]^T [J r] stands for both: it has the same squares. If the linear parameters come first, its
/// lower right part is what is left of the others and of r beside the linear ones: Kaufman's Jacobian and its
/// residuals. So a problem of n unknowns has n + 1 residuals, whatever the number of nodes.
class Projection {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  /// Refers to the sampled study.
  Projection(const StudyError& error, const SampledStudy<double>& sampled,
             std::optional<std::size_t> held = std::nullopt);

  int NumResiduals() const { return NumParameters() + 1; }
  int NumParameters() const { return static_cast<int>(nonlinear_.size()); }
  /// The unknowns, as indices of parameters.
  const std::vector<std::size_t>& nonlinear() const { return nonlinear_; }

  /// Sets the parameter that is held.
  void hold(double value) {
    parameters_[*held_] = value;
    is_at_place_ = false;
  }

  /// All parameters at the last place, the linear ones being the best there.
  const std::vector<double>& parameters() const { return parameters_; }

  /// Residuals of which the sum of squares is that of sqrt(weight) * error, and their derivatives.
  bool operator()(const double* q, double* residuals, double* jacobian) const;

 private:
  void move_to(const double* q) const;
  void factorise(std::span<const Eigen::Index> columns) const;
  /// How much of the square a step of the linear parameters takes away.
  double linear_share() const;
  void move_linear() const;

  const SampledStudy<double>& sampled_;
  std::optional<std::size_t> held_;
  std::vector<std::size_t> linear_, nonlinear_;
  /// Of the products: linear ones, nonlinear ones, the error; and the same without the nonlinear ones.
  std::vector<Eigen::Index> columns_, linear_columns_;
  mutable bool is_at_place_ = false;
  mutable std::vector<double> parameters_;
  mutable ProductMatrix<double> triangle_;  ///< R
};

}  // namespace shadefit
