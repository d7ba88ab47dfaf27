#pragma once

#include <vector>

#include "fit/minimax/alternation.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/tape/tape_program.hpp"

/// What a fit of a form that is linear in its parameters bounds: its error, its values, its slope.
namespace shadefit {

/// One coordinate for each variable of the study.
using Place = std::vector<double>;
using Wide = VectorOf<long double>;

/// A curve at a place, or a slope of it along the variables, and its derivatives by the parameters.
struct CurvePart {
  long double value;
  Wide slope;
};

/// A curve over the range that is linear in the parameters: at most share * level. Its sign is such that it
/// is bounded from above.
class LinearCurve {
 public:
  /// The curve of a formula of the study, or if `is_slope` of the formula's slope along the first variable.
  LinearCurve(const ReadStudy& study, Touch touch, double share, const Symbolic& formula, bool is_slope);

  Touch touch;
  double share;  ///< 1 for an error that the level bounds, 0 for a constraint
  const Tape& heights() const { return heights_; }

  /// The value, then the slopes along the variables, then the second slopes: (0, 0), (1, 0), (1, 1), (2, 0)
  /// ..
  std::vector<CurvePart> at(const Place& place, const Wide& parameters);

 private:
  std::size_t variables_;
  Tape heights_;
  TapeProgram<long double> parts_;
};

/// The curves of the error that the level bounds, then those of the constraints. Of `exact_at` there are two,
/// the error and its negative, which count at its places alone.
std::vector<LinearCurve> linear_curves(const ReadStudy& study, const Constraints& constraints);

/// The variables along which a place can move: those where it is at no edge.
std::vector<Eigen::Index> free_axes(const Place& place, const std::vector<std::vector<StudyEdge>>& edges);

/// The second slopes along some variables.
MatrixOf<double> curvature_along(const std::vector<CurvePart>& parts, std::size_t variables,
                                 const std::vector<Eigen::Index>& axes);

/// The top of a curve near a place, by Newton's method. A place that it does not improve stays.
Place top_near(LinearCurve& curve, Place place, const Wide& parameters,
               const std::vector<std::vector<StudyEdge>>& edges);

}  // namespace shadefit
