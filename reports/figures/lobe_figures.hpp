#pragma once

#include <vector>

#include "fit/verdicts/refit.hpp"
#include "reports/figures/figure.hpp"

/// The figures of the two lobe families. A panel needs the fit at its exponent; without the fit it is left
/// out.
namespace shadefit {

/// `lobe`, `lobe-errors`, `offset`: c^k by exp((k+x)(c-1)).
std::vector<Figure> gaussian_figures(const Refit& refit);

/// `phong-blinn`, `phong-blinn-errors`: cos^rho(theta) by cos^(x rho)(theta/2).
std::vector<Figure> phong_blinn_figures(const Refit& refit);

}  // namespace shadefit
