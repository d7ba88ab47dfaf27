#pragma once

#include <vector>

#include "fit/study/solve_study.hpp"
#include "fit/study/study_nodes.hpp"

namespace shadefit {

/// The largest |form - target| of a study at given parameters: the best of a grid between the edges, refined
/// between its neighbours. Sampled, not proven.
StudyExtremum largest_error(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                            const std::vector<double>& parameters);

/// The tops of |form - target| that may be the largest, or at least `share` of it, in the order of their
/// places. Each is the best of its hill of the same grid.
std::vector<StudyExtremum> tops_of_error(const ReadStudy& study,
                                         const std::vector<std::vector<StudyEdge>>& edges,
                                         const std::vector<double>& parameters, double share);

/// The study whose form is weight * (form - target), or that divided by the target, and whose target is 0.
ReadStudy weighted_error_of(const ReadStudy& study);

/// The largest |form - target| of a study: over its range, or over its rows.
StudyExtremum largest_error(const ReadStudy& study, const std::vector<double>& parameters);

/// The largest |weight * (form - target)|, or that divided by the target: what minimax minimises.
StudyExtremum largest_weighted_error(const ReadStudy& study, const std::vector<double>& parameters);

/// The row with the largest |form - value|; the first of those that are equal.
StudyExtremum largest_residual(const ReadStudy& study, const std::vector<double>& parameters);

}  // namespace shadefit
