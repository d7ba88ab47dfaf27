#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/exchange/curve_tops.hpp"
#include "fit/steps/linear_programme.hpp"

/// The lowest level of an error at a set of places, for a small step of the parameters, and whether it
/// determines them.
namespace shadefit {

using Places = std::vector<Place>;

/// The places as nodes of equal weights.
StudyNodes nodes_at(const Places& places);

/// The tops of the error that an exchange has seen so far.
class TopPlaces {
 public:
  /// With a coarse grid of the study's range, so that all parameters are determined from the start.
  explicit TopPlaces(const ReadStudy& study);

  const Places& all() const { return places_; }
  /// The next tops are seen from new parameters.
  void look_again() { ++look_; }
  /// A top near one of an earlier look is the same top, seen from better parameters, and replaces it. With
  /// both, the programme would have conditions that differ only by rounding.
  void add(const std::vector<double>& place);

 private:
  double distance(const std::vector<double>& a, const std::vector<double>& b) const;

  std::vector<double> widths_;  ///< of the range, for each variable
  Places places_ = {};
  std::vector<int> looks_ = {};  ///< the number of the look that found each place
  int look_ = 0;
};

/// A step of the linear programme, and where the error is at its level after it.
struct LevelStep {
  LowestLevel lowest;
  std::vector<std::size_t> places = {};  ///< indices in the set
  std::vector<double> signs = {};        ///< of the errors there
  double rounding = 0;                   ///< of form and target in double
};

/// The lowest level at the places, linearised at these parameters. `target_norm` is the size of the target's
/// values. Empty if n + 1 places do not determine it.
std::optional<LevelStep> level_step(const StudyError& error, const Places& places,
                                    const std::vector<double>& parameters, double target_norm);

/// The same of errors that are linear in the step, with a row of slopes for each.
std::optional<LevelStep> level_step(const VectorOf<double>& errors, const MatrixOf<double>& slopes,
                                    double rounding);

/// Whether only one set of parameters has the least level.
///
/// Each row of `slopes` is the gradient of |error| by the parameters, at a place where it is at the level.
/// Some rows, `support`, cancel each other with multipliers >= 0: no step lowers all these errors. A step
/// that raises none of the errors is possible only along rows whose multipliers are 0 in every such
/// combination. So the parameters are determined if the rows that can have a multiplier > 0 span all steps.
/// Other combinations are reached from the first one: a row enters with a small multiplier, and those of the
/// support fall. Source: the strict complementarity of Goldman, Tucker 1956, "Theory of linear programming",
/// in Linear Inequalities and Related Systems.
bool are_determined(const MatrixOf<double>& slopes, std::span<const std::size_t> support,
                    std::span<const double> multipliers);

}  // namespace shadefit
