#pragma once

#include "fit/study/search.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/study_squares/rules.hpp"

/// The optimum of a form with kinks that its parameters move, such as max(a x, b).
namespace shadefit {

/// Newton's method where kinks move with the parameters. The derivatives of the last place count the digits
/// with the next rule.
StudyFit settle_kinks(Rules& rules, const StudyCandidate& candidate);

}  // namespace shadefit
