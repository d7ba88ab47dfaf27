#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/study/study.hpp"
#include "fit/study_proof/study_box.hpp"
#include "fit/tape/tape.hpp"

/// The error of a study in interval arithmetic.
namespace shadefit {

/// A tape with its table, for many places one after the other.
class IntervalProgram {
 public:
  /// `parameters` are inputs after the variables.
  IntervalProgram(const Tape& tape, std::span<const Interval> parameters);
  IntervalProgram(const IntervalProgram&) = delete;  // the table points into the values
  IntervalProgram& operator=(const IntervalProgram&) = delete;

  /// Computes the outputs for the variables.
  void run(std::span<const Interval> variables);
  const Interval& output(std::size_t i) const { return values_[tape_.output(i)]; }

 private:
  Tape tape_;
  std::vector<Interval> values_;  ///< registers, inputs, constants
  std::vector<const Interval*> table_;
  std::vector<Interval*> registers_;
};

/// A bound of |error| on a box.
struct BoxBound {
  double bound = 0;           ///< infinite if none was found
  std::size_t axis = 0;       ///< the variable at which to cut the box for a better bound
  std::vector<double> place;  ///< where |error| may be large, if `hope` is a reason to look
  double hope = 0;            ///< at most this, near that place
};

/// weight * (form - target), or that divided by the target, on boxes and at places. Search and check share
/// it.
///
/// A formula with min, max or abs has slopes that enclose those of both sides. Where a choice, sign, floor or
/// atan2 may jump on a box, only values are enclosed, no slopes.
class EnclosedError {
 public:
  /// `parameters` in the order of those of the study.
  EnclosedError(const ReadStudy& study, std::span<const Interval> parameters);

  std::span<const Domain> ranges() const { return ranges_; }

  /// The error at a place of doubles.
  Interval at(std::span<const double> place);

  /// A bound on a box: by the values of the formula; or by the mean value theorem, f(x) = f(p) + sum of
  /// slope_i (x_i - p_i). p_i is an end of the box where f rises or falls with x_i, else the middle. A
  /// variable without bounded slope keeps all its numbers. Does no more work once a bound is at most
  /// `enough`.
  BoxBound bound_on(const StudyBox& box, double enough);

 private:
  struct Programs;
  EnclosedError(const ReadStudy& study, std::span<const Interval> parameters, Programs programs);

  bool may_jump() const;
  const Interval& value_on(const StudyBox& box);
  std::size_t widest(const StudyBox& box) const;

  std::vector<Domain> ranges_;
  std::vector<GraphNode> jumps_;  ///< their operands are the outputs of `value_` after the error, in order
  IntervalProgram value_, slopes_;
};

}  // namespace shadefit
