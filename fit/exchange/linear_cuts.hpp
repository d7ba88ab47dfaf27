#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fit/exchange/curve_tops.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/steps/alternation.hpp"
#include "fit/steps/linear_programme.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// A condition or a top is in units of the level, or of what a step of that size changes. Tops that exceed
/// their bounds by less are left to Newton's method.
inline constexpr double least_excess = 1e-10;

/// A curve over the range that is linear in the parameters: at most share * level. Its sign is such that it
/// is bounded from above.
struct LinearCurve {
  Touch touch;
  double share;        ///< 1 for an error that the level bounds, 0 for a constraint
  std::string broken;  ///< what it means that none can meet it: "no parameters keep the form <= 2"
  Tape heights;        ///< the curve
  CurveParts parts;
};

/// What is bounded at a place: a curve, or a slope of it.
struct Bounded {
  std::size_t curve;
  Place place;
  std::size_t part = 0;  ///< of the curve, 0 for its value
  double unit = 1;       ///< it is divided by this, which has its sign
};

/// Its condition on a step from the start.
struct Cut {
  Bounded of;
  Condition condition;
};

/// A fit of a form that is linear in its parameters.
struct LinearProblem {
  const ReadStudy& study;
  const StudyError& error;
  Norm norm;
  const Constraints& constraints;
  const Edges& edges;
  const SampledStudy<double>& sampled;
  const std::vector<double>& free;  ///< the fit without constraints, from which the steps start
  const Checkpoint& checkpoint;
};

/// Its conditions at the places so far, and the parameters that meet them.
struct LinearCuts : LinearProblem {
  explicit LinearCuts(const LinearProblem& problem);

  /// Chooses the units and the first places, so many that they determine the parameters. A step of 1 changes
  /// the error by its size; if `is_long`, it can also meet the constraints. False if it cannot.
  bool begin(bool is_long);
  /// Adds the tops that exceed their bounds. Returns by how much the highest does.
  double add_tops();

  Eigen::Index size() const { return steps.cols(); }
  std::vector<double> rounded() const { return {parameters.begin(), parameters.end()}; }
  void step_to(const VectorOf<double>& step) { parameters = start + (steps * step).cast<long double>(); }

  std::vector<CurvePart> parts(const Bounded& of) { return curves[of.curve].parts.at(of.place, parameters); }
  /// A slope by the parameters, along the steps.
  VectorOf<double> along(const Wide& slope) const { return steps.transpose() * slope.cast<double>(); }
  double share_of(const Bounded& of) const { return of.part == 0 ? curves[of.curve].share : 0; }
  Condition condition(const Bounded& of);
  /// By how much a curve exceeds its bound at a place, in the units of its condition.
  double excess(std::size_t curve, const CurvePart& part) const;
  /// Whether a curve is bounded everywhere, not at given places.
  bool is_searched(std::size_t curve) const {
    return curves[curve].touch != Touch::exact && (is_minimax || curves[curve].share == 0);
  }
  /// The tops of a curve, at least those near its bound or above.
  std::vector<Place> tops(std::size_t curve);
  /// Of an error, in units: it is the difference of two long doubles of the target's size.
  double rounding() const {
    return static_cast<double>(std::numeric_limits<long double>::epsilon()) * sampled.target_norm() / unit;
  }
  double width(Eigen::Index axis) const {
    const StudyAxis& of = study.axes[static_cast<std::size_t>(axis)];
    return of.upper - of.lower;
  }

  /// Ends the fit: no parameters meet the conditions, of which the most violated one is named. False.
  bool end_violated();

  const bool is_minimax;
  const Wide start;
  std::vector<LinearCurve> curves;
  Wide parameters;
  double level = 0;             ///< in units
  double unit = 0;              ///< of the error
  MatrixOf<double> steps = {};  ///< a step of 1 along each column changes the error by about a unit
  std::vector<Cut> cuts = {};
  StudyFit fit = {};  ///< what comes out; why, if the fit ends without an answer

 private:
  bool measure();
  bool cut_grid();
  /// Adds the condition of a curve at a place. False if no parameter moves it there and it is violated.
  bool cut(std::size_t curve, const Place& place);
  bool end_impossible(std::size_t curve, const Place& place);

  std::vector<double> largest_ = {};  ///< slope of each curve
};

}  // namespace shadefit
