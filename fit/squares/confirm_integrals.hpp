#pragma once

#include "fit/study/study.hpp"
#include "fit/study/study_fit.hpp"

namespace shadefit {

/// If a formula of the study has integrals, limits the digits to those in which two rules for them agree, as
/// a share of the target. With too few the fit is not converged.
void confirm_integrals(const ReadStudy& study, StudyFit& fit);

}  // namespace shadefit
