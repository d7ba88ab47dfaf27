#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/study/study_problem.hpp"

/// Least squares without the parameters that enter linearly.
namespace shadefit {

/// The reduced problem of variable projection, for a descent. Its unknowns are the parameters that do
/// not enter linearly; the others have their best values for them. One parameter may be held.
///
/// Let J be the derivatives and r the errors, one row per node, both times the roots of the weights. A
/// triangle R with R^T R = [J r]^T [J r] replaces both: it has the same squares. If the linear parameters
/// come first, its lower right part is what remains of the other columns and of r beside the linear ones:
/// Kaufman's Jacobian and its residuals. So a problem of n unknowns has n + 1 residuals, whatever the number
/// of nodes.
///
/// After a step the linear parameters follow to first order. R also tells how far they are from their best
/// then, so one evaluation of the nodes is enough for a point.
class Projection {
 public:
  /// Refers to the sampled study.
  Projection(const StudyError& error, const SampledStudy<double>& sampled,
             std::optional<std::size_t> held = std::nullopt);

  Eigen::Index residual_count() const { return unknown_count() + 1; }
  Eigen::Index unknown_count() const { return static_cast<Eigen::Index>(nonlinear_.size()); }
  /// The unknowns, as indices of parameters.
  const std::vector<std::size_t>& nonlinear() const { return nonlinear_; }

  /// Sets the parameter that is held.
  void hold(double value) {
    last_.parameters[*held_] = value;
    forget();
  }
  /// Forgets the earlier points: a descent from another start begins.
  void forget() const { last_.is_known = accepted_.is_known = false; }

  /// Appends what is known of the last point to a list of numbers, `kept_size()` of them; `recall` takes them
  /// back, to begin a descent there.
  void keep(std::vector<double>& numbers) const;
  void recall(std::span<const double> numbers) const;
  std::size_t kept_size() const { return last_.parameters.size() + columns_.size() * columns_.size(); }

  /// All parameters at the last point, with the best linear ones.
  const std::vector<double>& parameters() const { return last_.parameters; }

  /// Residuals whose sum of squares is that of sqrt(weight) * error, and their derivatives.
  void operator()(const double* q, double* residuals, double* jacobian) const;

 private:
  struct Point {
    bool is_known = false;
    std::vector<double> parameters;  ///< the linear ones are the best there
    ProductMatrix<double> triangle;  ///< R at linear parameters that may be one step before these
  };

  bool is_at(const Point& point, const double* q) const;
  void move_to(const double* q) const;
  /// Moves to a point near the accepted one. False if it is not near enough.
  bool follow(const double* q) const;
  /// Computes R. True if that succeeds by Cholesky: then the columns are independent.
  bool factorise(std::span<const Eigen::Index> columns) const;
  /// The share of the square that a step of the linear parameters removes.
  double linear_share() const;
  void move_linear() const;

  const SampledStudy<double>& sampled_;
  std::optional<std::size_t> held_;
  std::vector<std::size_t> linear_, nonlinear_;
  /// Columns of the products: linear parameters, nonlinear ones, the error; and the same without the
  /// nonlinear.
  std::vector<Eigen::Index> columns_, linear_columns_;
  mutable Point last_;
  mutable Point accepted_;  ///< where a step was accepted: the derivatives were asked for
};

}  // namespace shadefit
