#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/scalars/rounded_interval.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/scalars/taylor.hpp"
#include "fit/study/study_edges.hpp"

/// A formula of one variable in doubles that are rounded outward, and the boxes on which that explains it.
namespace shadefit {

/// A part of the range.
struct CurveBox {
  double left, right;
  double remainder;  ///< how far the formula may be from a polynomial

  double middle() const { return left + (right - left) / 2; }
};

class EnclosedCurve {
 public:
  EnclosedCurve(const Symbolic& formula, const std::string& variable);

  struct Value {
    double value, rounding;  ///< and how far rounding may have moved it
  };
  Value at(double x);

  CurveBox box(double left, double right);

 private:
  /// The highest Taylor coefficient. Order 8 needs the fewest boxes for its time: about 15 for sin(20 x), 40
  /// for acos(x).
  static constexpr int order = 8;

  using Number = RoundedInterval<OutwardArithmetic>;
  using Series = Taylor<order, Number>;

  TapeProgram<Number> value_;
  TapeProgram<Series> series_;
};

struct CurveBoxes {
  std::vector<CurveBox> boxes;       ///< rising; all those that are explained
  double range;                      ///< of the values that were seen, or the given one if that is larger
  std::optional<double> unresolved;  ///< a place where more than 32768 boxes would be needed
};

/// Divides the range between edges until what is unexplained on a box is below a share of the range of the
/// values, or rounding, or until the box cannot be halved: there is a jump, a pole or an infinite slope.
CurveBoxes boxes_of(EnclosedCurve& curve, const std::vector<StudyEdge>& edges, double share,
                    double least_range = 0);

}  // namespace shadefit
