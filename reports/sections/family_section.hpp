#pragma once

#include <string>
#include <vector>

#include "fit/verdicts/refit.hpp"
#include "reports/figures/figure.hpp"

/// The part of the report on one family.
namespace shadefit {

/// Its formulas, the published numbers and their verdicts, the best parameters and their errors, their limit,
/// the `figures` of the family, and mistyped copies in circulation.
std::string family_section(const Refit& refit, const std::vector<Figure>& figures);

}  // namespace shadefit
