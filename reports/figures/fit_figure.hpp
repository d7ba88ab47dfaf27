#pragma once

#include "fit/verdicts/refit.hpp"
#include "reports/figures/figure.hpp"

namespace shadefit {

/// The figure of a fit: the target and the form above, the error below, with the level of a minimax fit and
/// the places where the error touches it. Of a sweep: the parameters and the largest errors over the
/// exponent, and beside them target, form and error at three exponents. Only converged fits are drawn. Throws
/// UserError if there is none.
Figure fit_figure(const Refit& refit);

}  // namespace shadefit
