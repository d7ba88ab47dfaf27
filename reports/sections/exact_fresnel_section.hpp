#pragma once

#include <string>
#include <vector>

#include "fit/verdicts/fresnel_chain.hpp"
#include "reports/table/table.hpp"

/// The part of the report that asks for the truth behind Schlick's formula.
namespace shadefit {

/// One row per surface and curve: fresnel.csv. The surface is named by material and wavelength in nanometres,
/// the curve by the id of its published number, `schlick`, or `refitted` after the family.
Table fresnel_table(const std::vector<FresnelLink>& chain);

/// The chain from published form to Schlick to the exact reflectance of dielectrics and metals.
std::string exact_fresnel_section(const std::vector<FresnelLink>& chain);

/// How far Schlick's formula is from the truth on glass, in three sentences. Empty without a chain.
std::string exact_fresnel_headline(const std::vector<FresnelLink>& chain);

/// The headline, and the error of each curve on glass. Empty without a chain.
std::string exact_fresnel_lead(const std::vector<FresnelLink>& chain);

/// The rows of the chain for glass, index 1.5: what a reader asks first.
Table glass_table(const std::vector<FresnelLink>& chain);

}  // namespace shadefit
