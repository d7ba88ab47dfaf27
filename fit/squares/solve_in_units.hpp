#pragma once

#include <functional>
#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_fit.hpp"

/// Fits in units of the range.
namespace shadefit {

/// Fits a study from starts.
using SolveStudy = std::function<StudyFit(const ReadStudy& study, const std::vector<Held>& starts)>;

/// Fits a study in units in which its variables, its target and probably its parameters are of the size of 1,
/// if some are very far from it: squares of 1e-200 are nothing in double. The units are powers of two.
StudyFit solve_in_units(const ReadStudy& study, const std::vector<Held>& starts, const SolveStudy& solve);

/// Whether a study of one variable has a range, a target or a likely parameter so far from 1 that
/// `solve_in_units` changes its units.
bool needs_units(const ReadStudy& study);

}  // namespace shadefit
