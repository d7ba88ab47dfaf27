#pragma once

#include <optional>

#include "fit/exchange/linear_newton.hpp"
#include "fit/steps/linear_programme.hpp"
#include "fit/steps/quadratic_programme.hpp"

/// The programmes of a linear form on a growing set of conditions: cutting plane methods. Source: Kelley
/// 1960, "The cutting-plane method for solving convex programs", Journal of SIAM 8.
namespace shadefit {

/// The vertex of the linear programme.
struct LeastLevel {
  LowestLevel vertex;
  double rounding;  ///< of the level
};

/// Moves the cuts to the least level. Empty if there is none; then their fit has ended.
std::optional<LeastLevel> least_level(LinearCuts& cuts);

/// The least square of a linear form under its conditions.
class LeastSquare {
 public:
  /// Keeps a reference. The square is in units of the level's.
  explicit LeastSquare(LinearCuts& cuts);

  /// Half the square's second derivatives by the parameters, and along the steps.
  const MatrixOf<double>& raw_hessian() const { return raw_hessian_; }
  const MatrixOf<double>& hessian() const { return hessian_; }

  /// Moves the cuts to the least square of those with nearly their level. False if there is none.
  bool centre(double slack);

  /// Moves the cuts to the least square at their level and lists what touches. Those that touch already are
  /// equations; the first `before` cuts beside them say the same. False if no parameters meet the conditions;
  /// then the fit of the cuts has ended.
  bool lower(LinearNewton& newton, std::size_t before);

 private:
  std::optional<QuadraticAnswer> step(double slack, const std::vector<Touching>& held, std::size_t before,
                                      std::vector<const Cut*>& of) const;

  LinearCuts& cuts_;
  MatrixOf<double> raw_hessian_, hessian_;
  VectorOf<double> gradient_;
};

}  // namespace shadefit
