#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/steps/linear_programme.hpp"
#include "fit/study/study_fit.hpp"

/// Minimax: the parameters for which the largest |weight * error| over the domain is least.
///
/// At the optimum of a form with n free parameters the error has its largest magnitude, the level, at n + 1
/// places at least, usually with alternating signs: the alternation. The exchange starts near least squares.
/// It finds the extrema of the error and solves the linear programme of the lowest level there
/// (fit/steps/linear_programme.hpp). Its step is Newton's on the equations of the alternation. Then it
/// looks for the extrema again. A constraint is one more condition of the programme. The result is the best
/// near its start. It is not proven to be the best of all, and the search is sampled.
namespace shadefit {

using MinimaxParameters = std::vector<double>;
using WideParameters = std::vector<long double>;

/// A place of the search: s in [0, 1] on one of the panels of the domain.
struct SearchPlace {
  std::size_t panel = 0;
  double s = 0;
  bool operator==(const SearchPlace&) const = default;
};

/// A value along a panel, with its derivatives by s.
struct Along {
  double value, slope, curvature;
};

class PanelCurve;  // fit/panels/panel_curve.hpp

struct MinimaxProblem {
  std::size_t size = 0;             ///< free parameters
  std::vector<SearchPlace> places;  ///< by panel, then by s
  std::string variable;             ///< its name, for messages
  std::function<Cosine<double>(const SearchPlace&)> cosine_at;
  std::shared_ptr<PanelCurve> error = {};
  /// The curve that `at_most` and `at_least` bound, and the curve that is 0 where the form equals its target.
  /// These are the form and its error; for a positive form log(form) and log(form/target), which may be
  /// linear in the parameters.
  std::shared_ptr<PanelCurve> bounded = {}, deviation = {};
  std::shared_ptr<PanelCurve> sloping = {};  ///< the slope of the form, if `monotone` is set
  bool is_exponential = false;
  /// Constraints are linear in the parameters: if they cannot be satisfied together at some places, no
  /// parameters satisfy them.
  bool is_linear = false;
  std::optional<Side> one_sided = std::nullopt;
  std::optional<double> at_most = std::nullopt, at_least = std::nullopt;
  std::optional<Course> monotone = std::nullopt;
  std::vector<SearchPlace> exact_at = {};
  std::function<bool(const MinimaxParameters&)> is_admissible = [](const MinimaxParameters&) { return true; };
};

/// Exchanges until the alternation has settled, at most `most_steps`. Never throws for a hard problem. Of the
/// fit it gives parameters, status, the level, the alternation in falling order of the cosine, and the digits
/// of the worst parameter, floor(-log10 |Newton step / parameter|) in long double.
StudyFit solve_minimax(const MinimaxProblem& problem, const MinimaxParameters& start);

/// Three to six are usual. Distant starts need more, because their steps are halved.
inline constexpr int most_steps = 60;

}  // namespace shadefit
