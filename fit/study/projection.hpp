#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "fit/study/study_problem.hpp"

/// Least squares without the parameters that enter linearly.
namespace shadefit {

/// The reduced problem of variable projection, for ceres::TinySolver: its unknowns are the parameters that do
/// not enter linearly, the others are the best for them. One parameter may be held.
class Projection {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  /// Refers to the sampled study.
  Projection(const StudyError& error, const SampledStudy<double>& sampled,
             std::optional<std::size_t> held = std::nullopt);

  int NumResiduals() const { return static_cast<int>(sampled_.size()); }
  int NumParameters() const { return static_cast<int>(nonlinear_.size()); }
  /// The unknowns, as indices of parameters.
  const std::vector<std::size_t>& nonlinear() const { return nonlinear_; }

  /// Sets the parameter that is held.
  void hold(double value) { parameters_[*held_] = value; }

  /// All parameters at the last place, the linear ones being the best there.
  const std::vector<double>& parameters() const { return parameters_; }

  /// The residuals sqrt(weight) * error. Kaufman's Jacobian: the columns of the nonlinear parameters without
  /// their parts in the space of the linear ones.
  bool operator()(const double* q, double* residuals, double* jacobian) const;

 private:
  void project(Eigen::Map<VectorOf<double>>& result, double* jacobian) const;

  const SampledStudy<double>& sampled_;
  std::optional<std::size_t> held_;
  std::vector<std::size_t> linear_, nonlinear_;
  mutable std::vector<double> parameters_;
  mutable VectorOf<double> result_;
};

}  // namespace shadefit
