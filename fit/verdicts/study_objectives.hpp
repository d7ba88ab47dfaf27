#pragma once

#include <string>
#include <vector>

#include "fit/catalogue/fit_study.hpp"

/// The objectives under which the constants of a study may have been fitted.
namespace shadefit {

/// An objective with its words.
StudyObjective objective_of(const Study& study, Norm norm, const Constraints& constraints);

/// The same with a parameter held.
StudyObjective holding(StudyObjective objective, const std::string& parameter, double value);

/// Each norm with each error, with and without the study's weight, other than `asked`.
std::vector<StudyObjective> plain_objectives(const StudyObjective& asked);

/// The objectives other than `asked` under which a number may have been fitted: the plain ones first. If the
/// target is a formula of one variable, also least squares under the usual densities of a variable in [0, 1],
/// minimax that is exact at one end or at both, least squares on evenly spaced samples of usual sizes, and
/// each norm with each error on usual parts of the range. Of two variables: least squares under those
/// densities of each, on grids of usual sizes, and on parts; the target is then a formula, or, for the grids,
/// `recompute`.
std::vector<StudyObjective> other_objectives(const StudyObjective& asked);

/// Least squares that are exact at one end of the range or at both, with each error, where the form with
/// these printed constants is; empty of rows and of several variables.
std::vector<StudyObjective> exact_least_squares(const StudyObjective& asked,
                                                const std::vector<std::string>& printed);

}  // namespace shadefit
