#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fit/exchange/curve_tops.hpp"
#include "fit/steps/linear_programme.hpp"

/// The lowest level of an error at a set of places, for a small step of the parameters.
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

}  // namespace shadefit
