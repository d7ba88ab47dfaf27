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
///
/// After a step the linear parameters follow to first order. What they lack then, R tells too, so one look at
/// the nodes is enough for a place.
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
    last_.parameters[*held_] = value;
    forget();
  }
  /// Forgets the places before: a descent from another start begins.
  void forget() const { last_.is_known = accepted_.is_known = false; }

  /// All parameters at the last place, the linear ones being the best there.
  const std::vector<double>& parameters() const { return last_.parameters; }

  /// Residuals of which the sum of squares is that of sqrt(weight) * error, and their derivatives.
  bool operator()(const double* q, double* residuals, double* jacobian) const;

 private:
  struct Place {
    bool is_known = false;
    std::vector<double> parameters;  ///< the linear ones are the best there
    ProductMatrix<double> triangle;  ///< R, with linear parameters that may be a last step away from them
  };

  bool is_at(const Place& place, const double* q) const;
  void move_to(const double* q) const;
  /// To a place near the accepted one. False if it is not near enough.
  bool follow(const double* q) const;
  /// Computes R. True if that succeeds by Cholesky: then the columns are independent.
  bool factorise(std::span<const Eigen::Index> columns) const;
  /// How much of the square a step of the linear parameters takes away.
  double linear_share() const;
  void move_linear() const;

  const SampledStudy<double>& sampled_;
  std::optional<std::size_t> held_;
  std::vector<std::size_t> linear_, nonlinear_;
  /// Of the products: linear ones, nonlinear ones, the error; and the same without the nonlinear ones.
  std::vector<Eigen::Index> columns_, linear_columns_;
  mutable Place last_;
  mutable Place accepted_;  ///< where a step was accepted: the derivatives were asked for
};

}  // namespace shadefit
