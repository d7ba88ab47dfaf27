#pragma once

#include <string>

#include "reports/results.hpp"

/// The part of the report that asks for the truth behind Schlick's formula.
namespace shadefit {

/// Where the approximations stand against exact dielectrics of three indices: Schlick's formula itself, the
/// published curves of a Fresnel family, and its form refitted to the truth.
std::string exact_fresnel_section(const FittableFamily& family);

/// One sentence that the report leads with: how far each curve is from the truth at n = 1.5. Empty without a
/// Fresnel family among the results.
std::string exact_fresnel_lead(const Results& results);

}  // namespace shadefit
