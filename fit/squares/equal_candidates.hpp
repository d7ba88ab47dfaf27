#pragma once

#include <string>
#include <vector>

#include "fit/study/search.hpp"
#include "fit/study/study_problem.hpp"

/// Candidates that are as good as each other, and which of them is the answer.
namespace shadefit {

/// The candidates whose square is the best one: other parameters may reach the optimum too.
std::vector<StudyCandidate> best_of(const std::vector<StudyCandidate>& candidates, double target_norm);

/// Whether two candidates give the same curve.
bool is_same_curve(const SampledStudy<double>& sampled, const StudyCandidate& a, const StudyCandidate& b);

/// If several sets of parameters give one curve, the one that comes first, number by number. With rows the
/// smallest comes first, because every faster wave through evenly spaced rows fits as well.
StudyCandidate canonical(const ReadStudy& study, const SampledStudy<double>& sampled,
                         const std::vector<StudyCandidate>& best);

/// Names the parameters that can change while the curve stays the same. Empty if there are none.
std::string flat_direction(const ReadStudy& study, const SampledStudy<double>& sampled,
                           const std::vector<double>& parameters);

}  // namespace shadefit
