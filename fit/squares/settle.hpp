#pragma once

#include "fit/squares/rules.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/study/study_problem.hpp"

/// From the basin of a search to the optimum, with the digits that are right.
namespace shadefit {

/// Why an optimum has too few digits under all rules.
inline constexpr const char* still_moved =
    "the largest quadrature rule still moves a parameter in its sixth digit";

/// Polishes a candidate in long double, on one rule after the other, until the next rule moves no parameter.
/// `searched` is the study under the first rule, if its panels are still the same.
StudyFit settle(const Rules& rules, const StudyCandidate& candidate, const SampledStudy<double>* searched);

/// Newton's method where kinks move with the parameters. The derivatives of the last place count the digits
/// with the next rule.
StudyFit settle_kinks(Rules& rules, const StudyCandidate& candidate);

/// A fit as Newton's method left it, with the digits that its data have. A form that is linear in all
/// parameters needs no start: long double solves it where Newton's method failed. Where roundings of long
/// double may move a parameter in its last digits, and the nodes are few enough, 50 digits settle it.
/// `sampled` is under the first rule.
StudyFit with_all_digits(const ReadStudy& study, const Rules& rules, const SampledStudy<double>& sampled,
                         bool is_linear, StudyFit fit);

}  // namespace shadefit
