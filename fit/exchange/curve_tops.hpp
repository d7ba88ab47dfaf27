#pragma once

#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/study/study_problem.hpp"

/// The tops of curves over the range of a study, to the digits of long double.
namespace shadefit {

/// One coordinate for each variable of the study.
using Place = std::vector<double>;
using Wide = VectorOf<long double>;
using Edges = std::vector<std::vector<StudyEdge>>;

Wide wide(const std::vector<double>& parameters);

/// A curve at a place, or a slope of it along the variables, and its derivatives by the parameters.
struct CurvePart {
  long double value;
  Wide slope;
};

/// A curve and its slopes as formulas.
class CurveParts {
 public:
  /// The curve of a formula of the study, or if `is_slope` of the formula's slope along the first variable.
  /// Without derivatives by the parameters if not `has_derivatives`.
  CurveParts(const ReadStudy& study, const Symbolic& formula, bool is_slope, bool has_derivatives);

  /// The value, then the slopes along the variables, then the second slopes: (0, 0), (1, 0), (1, 1), (2, 0)
  /// ..
  std::vector<CurvePart> at(const Place& place, const Wide& parameters);

 private:
  std::size_t variables_, derivatives_;
  TapeProgram<long double> parts_;
};

/// Whether two places differ by at most this share of the range along each variable.
bool are_near(const Place& a, const Place& b, const std::vector<StudyAxis>& axes, double share);

/// The variables along which a place can move: those where it is at no edge.
std::vector<Eigen::Index> free_axes(const Place& place, const Edges& edges);

/// The second slopes along some variables.
MatrixOf<double> curvature_along(const std::vector<CurvePart>& parts, std::size_t variables,
                                 const std::vector<Eigen::Index>& axes);

/// The top of a curve near a place, by Newton's method. A place that it does not improve stays.
Place top_near(CurveParts& curve, Place place, const Wide& parameters, const Edges& edges);

/// The tops of the magnitude of a study's error.
class ErrorTops {
 public:
  ErrorTops(const ReadStudy& study, const Edges& edges);

  /// The top near a place.
  Place near(const Place& place, const std::vector<double>& parameters);

  /// Those with at least 0.3 of the largest. Places of one hill may stand for several of its tops.
  std::vector<StudyExtremum> all(const std::vector<double>& parameters);

 private:
  ReadStudy weighted_;  ///< the form is the error
  Edges edges_;
  CurveParts error_, negative_;
};

}  // namespace shadefit
