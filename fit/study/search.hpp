#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fit/study/study_problem.hpp"
#include "fit/support/checkpoint.hpp"

/// The basins of a study's least squares.
namespace shadefit {

/// Where a descent ended.
struct StudyCandidate {
  std::vector<double> parameters;
  double square;  ///< sum of weight * error^2
};

/// Where descents start.
struct SearchStarts {
  std::size_t count;  ///< of a low-discrepancy sequence, from its element `first` on
  int octaves;        ///< its values are of either sign, of sizes from 2^-octaves to 2^octaves
  std::vector<std::vector<double>> given;
  /// The units of all parameters, powers of two, if some are far from 1. Then as many starts again have these
  /// units.
  std::vector<double> units = {};
  /// If the form has positions, as d of (x - d)^2: the range of each parameter that is one, empty for the
  /// others. Then twice as many starts again have positions evenly in their ranges, and the others around
  /// `sizes`.
  std::vector<std::optional<std::array<double, 2>>> ranges = {};
  std::vector<double> sizes = {};
  std::size_t first = 1;
  std::vector<std::array<double, 2>> bounds = {};  ///< of all parameters, if any has: starts lie inside

  std::size_t sets() const { return std::size_t{1} + !units.empty() + 2 * !ranges.empty(); }
};

/// The ends of descents, best first, without those that have a pole or no finite error. One entry if the form
/// is linear in all parameters. `coarse` has the same or fewer nodes, for the first steps from every start.
std::vector<StudyCandidate> search_basins(const StudyError& error, const SampledStudy<double>& coarse,
                                          const SampledStudy<double>& sampled, const SearchStarts& starts,
                                          const Checkpoint& checkpoint = keep_going);

/// A study searched on the nodes of a small rule.
struct SearchedStudy {
  SampledStudy<double> sampled;
  std::vector<StudyCandidate> candidates;  ///< best first; never empty
  int starts;
  bool is_linear;  ///< in all parameters: then the only candidate is the best of all
  bool has_rows = false;
};

/// The sum of the squares of parameters.
double size_of(const std::vector<double>& parameters);

/// Whether parameters are clearly smaller than others that give the same errors. Every faster wave through
/// evenly spaced rows fits as well as a slow one, and is wrong between the rows.
bool is_slower_wave(const std::vector<double>& a, const std::vector<double>& b);

/// The lowest basins, at most so many, as starts for another problem with the same form. One candidate for
/// each different square; with rows the slowest wave of those that have it.
std::vector<StudyCandidate> lowest_basins(const SearchedStudy& searched, std::size_t most = 4);

/// A start of all parameters: those that are not given are 1, and those outside their bounds are moved to
/// them.
std::vector<double> start_of(const ReadStudy& study, const std::vector<Held>& starts);

/// Within bounds the starts lie inside them, and so do all candidates if any does. Throws UserError where a
/// formula has no value in the range, and if no start has a finite error.
SearchedStudy search_study(const ReadStudy& study, const StudyError& error,
                           const std::vector<std::vector<StudyEdge>>& edges, const std::vector<Held>& starts,
                           const Checkpoint& checkpoint = keep_going);

/// The rule of the search, an index of `fit_rules`: 30 nodes on a panel see every basin of a smooth form, and
/// products of rules need fewer on each axis.
std::size_t search_rule(const ReadStudy& study);

/// The starts for so many parameters that do not enter linearly. Constants of shading are between 1/64 and 64
/// in size, because their variables are of the size of 1. Rows have units: if their numbers are larger or
/// smaller, the range is wider and there are more starts.
SearchStarts starts_of(const ReadStudy& study, std::size_t nonlinear);

/// The units of all parameters for `SearchStarts`, from the ranges of the variables and from the size of the
/// values of the target (fit/scalars/likely_sizes.hpp). Empty if all are near 1.
std::vector<double> units_of(const ReadStudy& study, const std::vector<double>& target);
/// The same, of all, near 1 or not.
std::vector<double> sizes_of(const ReadStudy& study, const std::vector<double>& target);

}  // namespace shadefit
