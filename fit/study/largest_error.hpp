#pragma once

#include <optional>
#include <vector>

#include "fit/formula/tape.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/study/study_fit.hpp"

namespace shadefit {

/// The largest |form - target| of a study at given parameters: the best place of a grid between the edges,
/// refined between its neighbours. Sampled, not proven. 0 at the first place if it is mostly the rounding of
/// double, as that of an exact form is.
StudyExtremum largest_error(const ReadStudy& study, const std::vector<std::vector<StudyEdge>>& edges,
                            const std::vector<double>& parameters);

/// The tops of |form - target| that may be the largest or reach `share` of it, in the order of their places.
/// Each is the top of one hill of the same grid.
std::vector<StudyExtremum> tops_of_error(const ReadStudy& study,
                                         const std::vector<std::vector<StudyEdge>>& edges,
                                         const std::vector<double>& parameters, double share);

/// The same for the first output of a tape where it is positive. With a ground its magnitude is that of its
/// finite values above it.
std::vector<StudyExtremum> tops_of(const Tape& curve, std::optional<double> ground,
                                   const std::vector<std::vector<StudyEdge>>& edges,
                                   const std::vector<double>& parameters, double share);

/// The study with the form weight * (form - target), divided by the target if the error is relative. Its
/// target is 0.
ReadStudy weighted_error_of(const ReadStudy& study);

/// A zero of one of the `moving_poles` inside the range of the only variable. A pole between two places of a
/// search or two nodes of a fit has no width, and nodes do not reach the ends.
std::optional<double> pole_of(const ReadStudy& study, const std::vector<double>& parameters);

/// The largest |form - target| of a study: over its range, infinite at a pole, or over its rows.
StudyExtremum largest_error(const ReadStudy& study, const std::vector<double>& parameters);

/// The largest weighted error, relative if the study says so: what minimax minimises.
StudyExtremum largest_weighted_error(const ReadStudy& study, const std::vector<double>& parameters);

/// The row with the largest |form - value|; the first of those that are equal.
StudyExtremum largest_residual(const ReadStudy& study, const std::vector<double>& parameters);

}  // namespace shadefit
