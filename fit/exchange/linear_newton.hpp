#pragma once

#include <vector>

#include "fit/exchange/linear_cuts.hpp"

namespace shadefit {

/// Cuts that are this near, as a share of the range, stand for one top.
inline constexpr double near_top = 1e-3;

/// A condition that holds with equality at the answer.
struct Touching {
  Bounded of;
  double multiplier;
  bool is_held;  ///< an equation: the place stays, and the multiplier may have either sign
};

/// Newton's method on the equations of Karush, Kuhn and Tucker. The places move with the parameters to the
/// tops of their curves.
class LinearNewton {
 public:
  /// Moves the parameters and the level of these.
  explicit LinearNewton(LinearCuts& cuts) : cuts_(cuts) {}

  std::vector<Touching> touching = {};

  /// Adds a condition that touches if it has a multiplier. Cuts of one curve within `same_top` of the range
  /// stand for one top.
  void touch(const Cut& cut, double multiplier, double same_top = near_top);

  /// One step. The unknowns are the parameters along the steps, the level if it is not given, the
  /// multipliers, and the places that move. `gradient` is that of what is minimised, `hessian` its
  /// derivative. Returns the step of the parameters.
  Wide step(const MatrixOf<double>& hessian, const Wide& gradient, bool has_level);

  /// Finds the least level that the touching conditions hold. False if the steps do not end.
  bool settle_level();

  /// Whether no multiplier of an inequality is negative beyond rounding.
  bool has_signs() const;

  /// Replaces the touching conditions by those that all parameters with the same level share. At a place of
  /// the level the error has this value. It is stationary, or falls from an end of the range: then it adds a
  /// cut. Returns whether these conditions determine the parameters.
  bool hold_level();

 private:
  /// The touching conditions with the variables along which their places move.
  struct Moving {
    std::vector<std::vector<Eigen::Index>> axes = {};
    Eigen::Index count = 0;  ///< of the coordinates that move
  };
  Moving moving();
  std::vector<Eigen::Index> moving_axes(const Touching& t, const std::vector<CurvePart>& parts) const;
  Wide take(VectorOf<double> step, const Moving& moving, bool has_level);
  long double relative(const Wide& step) const;
  void hold_slopes(const Touching& t, std::vector<Touching>& held);

  LinearCuts& cuts_;
};

}  // namespace shadefit
