#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/scalars/hinges.hpp"

/// The zeros of the parts at which a formula is not smooth.
namespace shadefit {

/// A place where some formula of a study is not smooth in a variable.
struct StudyEdge {
  double at;
  int power = 1;         ///< the formula is smooth in this root of the distance
  bool is_jump = false;  ///< whether it has another value on each side, and perhaps a third one here
};

/// How close to a root or a logarithm the nodes go.
inline constexpr int power_at_root = 8;

/// A hinge along one variable. The other variables have given values.
class HingeCurve {
 public:
  /// `variables` are that variable and then the others.
  HingeCurve(Hinge hinge, std::span<const std::string> variables);

  /// Gives the other variables their values.
  void set_others(std::span<const long double> values);

  /// Whether it is a root that is zero at x.
  bool is_root_at(double x);

  /// Appends the zeros on a range as edges. The search looks at 592 places, so it can miss two zeros that are
  /// closer.
  void append_zeros(double lower, double upper, std::vector<StudyEdge>& edges);

 private:
  struct Programs;

  Hinge hinge_;
  std::shared_ptr<Programs> programs_;
};

}  // namespace shadefit
