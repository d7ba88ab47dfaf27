#pragma once

#include <string_view>
#include <vector>

#include "fit/better/results.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/files.hpp"

/// The figures of the report.
namespace shadefit {

/// The figures that the results allow: those of each refitted family whose fits all converged.
std::vector<Figure> make_figures(const Results& results);

/// plots/NAME.csv and plots/NAME.gnuplot of each.
std::vector<File> plot_files(const std::vector<Figure>& figures);

/// Of Fresnel's term, `fresnel` and `fresnel-errors`, for the section of that family: the published forms,
/// Schlick's formula and the exact dielectric.
std::vector<Figure> fresnel_figures(std::string_view family);

/// Of the two lobe families. A panel needs the fit at its exponent; without the fit it is left out.
/// `lobe`, `lobe-errors`, `offset`: c^k by exp((k+x)(c-1)).
std::vector<Figure> gaussian_figures(const Refit& refit);

/// `phong-blinn`, `phong-blinn-errors`: cos^rho(theta) by cos^(x rho)(theta/2).
std::vector<Figure> phong_blinn_figures(const Refit& refit);

}  // namespace shadefit
