#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/better/results.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/table.hpp"

/// The parts of the report.
namespace shadefit {

/// The news: the refuted and the conditional claims, which do not hold or only in part: the statement, the
/// evidence, and the effect on a picture.
std::string news_section(const std::vector<JudgedClaim>& claims);

/// Stands above a list of conditional claims.
inline constexpr std::string_view conditional_lead =
    "**Conditional:** true only for a part of the range, or only in one interpretation of the words:";

/// The claims with a verdict, in the order of the ledger.
std::vector<JudgedClaim> claims_with(const std::vector<JudgedClaim>& claims, Verdict verdict);

/// One family: its formulas, the published numbers and their verdicts, the best parameters and their errors,
/// their limit, the `figures` of the family, and mistyped copies in circulation.
std::string family_section(const Refit& refit, const std::vector<Figure>& figures);

/// The exact reflectance, which Schlick's formula approximates: the chain from published form to Schlick to
/// the exact reflectance of dielectrics and metals.
std::string exact_fresnel_section(const std::vector<FresnelLink>& chain);

/// The error of Schlick's formula on glass, in three sentences. Empty without a chain.
std::string exact_fresnel_headline(const std::vector<FresnelLink>& chain);

/// The headline, and the error of each curve on glass. Empty without a chain.
std::string exact_fresnel_lead(const std::vector<FresnelLink>& chain);

/// One row per surface and curve: fresnel.csv. The surface is named by material and wavelength in nanometres,
/// the curve by the id of its published number, `schlick`, or `refitted` after the family.
Table fresnel_table(const std::vector<FresnelLink>& chain);

/// Better constants and forms at the same cost: a table for each target, and for each published curve the
/// best one.
std::string better_section(const std::vector<TargetComparison>& comparisons);

/// Each normalisation constant and 1 over its integral; the ratio of the cheap to the exact constant over the
/// exponent.
std::string normalisation_section(const Results& results);

/// Normalised lobes at views other than v = n: a table of reflectances for each constant, one of the largest,
/// and their effect on energy.
std::string reflectance_section(const std::vector<ReflectanceCurve>& curves);

/// One row per constant, exponent and view angle: reflectance.csv.
Table reflectance_table(const std::vector<ReflectanceCurve>& curves);

}  // namespace shadefit
