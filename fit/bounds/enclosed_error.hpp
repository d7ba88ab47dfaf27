#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fit/bounds/error_limits.hpp"
#include "fit/bounds/jumps.hpp"
#include "fit/bounds/study_box.hpp"
#include "fit/bounds/study_integral.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/proof/constants.hpp"
#include "fit/proof/interval.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/study/study.hpp"

/// The error of a study in interval arithmetic.
namespace shadefit {

/// A bound of |error| on a box.
struct BoxBound {
  double bound = 0;           ///< infinite if none was found
  std::size_t axis = 0;       ///< the variable at which to cut the box for a better bound
  std::vector<double> place;  ///< where |error| may be large
};

/// The study with the same error and without terms that its target shares with its form, where decimals are
/// in place of these parameters: an interval less itself is twice as wide, not 0. It is the study itself if
/// they share no term.
ReadStudy without_equal_terms(const ReadStudy& study, const Constants& parameters);

/// The weighted error of a study, relative if the study says so, on boxes and at places. Search and check
/// share it.
///
/// Integrals are enclosed first (fit/bounds/study_integral.hpp), and the chain rule uses their slopes. A
/// formula with min, max or abs has slopes that enclose those of both sides. If a choice, sign, floor or
/// atan2 may jump on a box, only values are enclosed. In one variable 0/0 has its limit
/// (fit/bounds/error_limits.hpp).
class EnclosedError {
 public:
  /// `parameters` in the order of those of the study. `known` has what other proofs computed.
  EnclosedError(const ReadStudy& study, std::span<const Interval> parameters, KnownIntegrals known = {});

  std::span<const Domain> ranges() const { return ranges_; }
  bool has_integrals() const { return !integrals_.empty(); }

  /// The error at a place of doubles.
  Interval at(std::span<const double> place);

  /// A bound on a box: by the values of the formula, or by the mean value theorem, f(x) = f(p) + sum of
  /// slope_i (x_i - p_i). p_i is an end of the box if f rises or falls with x_i, otherwise the middle. A
  /// variable without a bounded slope keeps its whole interval. In one variable the slope is bounded by its
  /// own mean value theorem too: slopes of form and target cancel at a place, but not on a box. Stops early
  /// if a bound is at most `enough`.
  BoxBound bound_on(const StudyBox& box, double enough);

 private:
  std::vector<Interval> with_integrals(std::vector<Interval> variables);
  const Interval& value_for(std::vector<Interval> variables);
  std::vector<Interval> slopes_for(std::vector<Interval> variables);
  std::vector<Interval> slopes_on(const StudyBox& box);
  Interval value_or_limit(const std::vector<Interval>& place);
  double bound_by_ends(const Stretch& stretch);
  Interval curvature_for(const std::vector<Interval>& variables);

  std::vector<Domain> ranges_;
  /// Of the error and of its slopes, where kinks are jumps. Their deciding nodes are the last outputs of
  /// `value_` and of `slopes_`.
  Jumps jumps_, kinks_;
  std::vector<std::shared_ptr<StudyIntegral>> integrals_;
  std::optional<ErrorLimits> limits_;  ///< where a denominator or a logarithm may be 0
  /// Functions of the variables and the integrals. The last has the second derivatives of one variable.
  std::optional<TapeProgram<Interval>> value_, slopes_, curvatures_;
};

}  // namespace shadefit
