#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/study/study.hpp"

/// The integrals of a study in interval arithmetic.
namespace shadefit {

/// An integral inside a formula, enclosed on boxes of the variables.
///
/// Its variable is mapped to [0, 1], which is cut into panels. On a panel of middle m and radius r the
/// integral of f is the sum of 2 f_j r^(j+1)/(j+1) over even j < n, where f_j are the Taylor coefficients at
/// m, and the remainder 2 f_n r^(n+1)/(n+1) with f_n enclosed on all of the panel, n even. If f has no
/// series, as sqrt(t) at t = 0, it is the panel's length times the range of f. The panel that adds most to
/// the width is cut first.
class StudyIntegral {
 public:
  /// `integral` has no other integral inside. `parameters` are in the order of those of the study.
  StudyIntegral(const ReadStudy& study, const Symbolic& integral, std::span<const Interval> parameters);
  ~StudyIntegral();

  /// The integral for variables in these intervals; unbounded if no bound was found.
  Interval value(std::span<const Interval> variables);

  /// Its derivatives by the variables. They are unbounded if the body may jump.
  std::vector<Interval> slopes(std::span<const Interval> variables);

  /// Its second derivative by the first variable. It is unbounded if the body may jump or has a kink.
  Interval curvature(std::span<const Interval> variables);

 private:
  class Panels;
  std::unique_ptr<Panels> value_, slopes_, curvature_;  ///< only the first if the body may jump
};

/// The integrals of several proofs about the same variables. One without a parameter is the same in all of
/// them, and is enclosed once on each box. Copies share what they know.
class KnownIntegrals {
 public:
  std::shared_ptr<StudyIntegral> of(const ReadStudy& study, const Symbolic& integral,
                                    std::span<const Interval> parameters);

 private:
  using ByText = std::map<std::string, std::shared_ptr<StudyIntegral>>;
  std::shared_ptr<ByText> known_ = std::make_shared<ByText>();
};

}  // namespace shadefit
