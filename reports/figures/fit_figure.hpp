#pragma once

#include "fit/verdicts/refit.hpp"
#include "reports/figures/figure.hpp"

namespace shadefit {

/// The figure of a fit: the target and the form above, the error below, with the level of a minimax fit and
/// the places where the error touches it. Of a sweep: the parameters above, the errors below, over the
/// exponent. Draws what converged; without such a fit, throws UserError.
Figure fit_figure(const Refit& refit);

}  // namespace shadefit
