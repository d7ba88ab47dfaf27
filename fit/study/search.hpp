#pragma once

#include <vector>

#include "fit/study/search_starts.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/checkpoint.hpp"

/// The basins of a study's least squares.
namespace shadefit {

/// Where a descent ended.
struct StudyCandidate {
  std::vector<double> parameters;
  double square;  ///< sum of weight * error^2
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

/// Whether parameters are clearly smaller than others that give the same errors. Every faster wave through
/// evenly spaced rows fits as well as a slow one, and is wrong between the rows.
bool is_slower_wave(const std::vector<double>& a, const std::vector<double>& b);

/// The lowest basins, at most so many, as starts for another problem with the same form. One candidate for
/// each different square; with rows the slowest wave of those that have it.
std::vector<StudyCandidate> lowest_basins(const SearchedStudy& searched, std::size_t most = 4);

/// Within bounds the starts lie inside them, and so do all candidates if any does. Throws UserError where a
/// formula has no value in the range, and if no start has a finite error.
SearchedStudy search_study(const ReadStudy& study, const StudyError& error,
                           const std::vector<std::vector<StudyEdge>>& edges, const std::vector<Held>& starts,
                           const Checkpoint& checkpoint = keep_going);

/// The rule of the search, an index of `fit_rules`: 30 nodes on a panel see every basin of a smooth form, and
/// products of rules need fewer on each axis.
std::size_t search_rule(const ReadStudy& study);

}  // namespace shadefit
