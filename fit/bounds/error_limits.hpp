#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fit/formula/graph.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/proof/interval.hpp"

namespace shadefit {

/// Enclosures of an error of one variable where a quotient of it is 0/0 and has a limit.
///
/// Let a and b be 0 at a place p, with their first k - 1 derivatives. Then a = (x - p)^k A and b = (x - p)^k
/// B with smooth A and B. Over an interval with p in it, a^(k+j)/(k+j)! encloses A^(j)/j!, which is a mean of
/// it between p and x. So a/b = A/B and its derivatives are enclosed. u log(v) is 0 at a place where u and v
/// are, if there u has a slope, and v one that is not 0.
///
/// Zeros count where an enclosure is exactly 0: log(1 + x) at x = 0, but not sin(x) at a double next to pi. A
/// formula with a kink or a jump has no such limits here.
class ErrorLimits {
 public:
  /// `error` is the last node of the graph, whose inputs are the variable and the parameters. The places are
  /// those where a denominator may be 0.
  ErrorLimits(Graph& graph, int error, std::span<const double> places, std::span<const Interval> parameters);

  /// The error and its derivatives.
  struct Derivatives {
    Interval value, slope, curvature;
  };
  /// On an interval, by the first place that gives them a bound; empty if none does.
  std::optional<Derivatives> on(const Interval& x);
  /// The error at one of the places.
  std::optional<Interval> at(const Interval& x);

 private:
  struct Place {
    double at;
    TapeProgram<Interval> beside, here;  ///< the error and its derivatives; the error
  };

  std::vector<Place> places_;
};

}  // namespace shadefit
