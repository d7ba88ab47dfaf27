#pragma once

#include <string>
#include <vector>

#include "fit/verdicts/fresnel_chain.hpp"
#include "reports/table/table.hpp"

/// The part of the report on the exact reflectance, which Schlick's formula approximates.
namespace shadefit {

/// One row per surface and curve: fresnel.csv. The surface is named by material and wavelength in nanometres,
/// the curve by the id of its published number, `schlick`, or `refitted` after the family.
Table fresnel_table(const std::vector<FresnelLink>& chain);

/// The chain from published form to Schlick to the exact reflectance of dielectrics and metals.
std::string exact_fresnel_section(const std::vector<FresnelLink>& chain);

/// The error of Schlick's formula on glass, in three sentences. Empty without a chain.
std::string exact_fresnel_headline(const std::vector<FresnelLink>& chain);

/// The headline, and the error of each curve on glass. Empty without a chain.
std::string exact_fresnel_lead(const std::vector<FresnelLink>& chain);

/// The rows of the chain for glass, index 1.5.
Table glass_table(const std::vector<FresnelLink>& chain);

}  // namespace shadefit
