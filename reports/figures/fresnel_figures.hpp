#pragma once

#include <string_view>
#include <vector>

#include "reports/figures/figure.hpp"

/// The figures of Fresnel's term: the published forms, Schlick's formula and the exact dielectric.
namespace shadefit {

/// `fresnel`, `fresnel-errors`, for the section of that family.
std::vector<Figure> fresnel_figures(std::string_view family);

}  // namespace shadefit
