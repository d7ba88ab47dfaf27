#pragma once

#include "fit/study/search.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/study_squares/rules.hpp"

/// From the basin of a search to the optimum, with the digits that are right: three ways, by the form.
namespace shadefit {

/// Polishes a candidate in long double, on one rule after the other, until the next rule moves no parameter.
/// `searched` is the study under the first rule, if its panels are still the same.
StudyFit settle(const Rules& rules, const StudyCandidate& candidate, const SampledStudy<double>* searched);

/// Newton's method where kinks move with the parameters. The derivatives of the last place count the digits
/// with the next rule.
StudyFit settle_kinks(Rules& rules, const StudyCandidate& candidate);

/// The optimum of a form that is linear in all parameters, in long double, by one rule after the other.
StudyFit settle_linear(const Rules& rules);

/// The optimum in 50 digits, by one rule after the other. `start` is near it, or the form is linear in all
/// parameters.
StudyFit settle_in_50_digits(const ReadStudy& study, const Rules& rules, const std::vector<double>& start);

/// Whether a parameter may move in its last digits by the roundings of errors in long double, which are
/// shares of the target, and the nodes are few enough for errors in 50 digits. Without parameters, which did
/// not settle, it may.
bool needs_50_digits(const ReadStudy& study, const SampledStudy<double>& sampled,
                     const std::vector<double>& parameters);

}  // namespace shadefit
