#pragma once

#include <nlohmann/json.hpp>

#include "fit/refit.hpp"

/// Fits as JSON, every number to its shortest round trip.
namespace shadefit {

/// The version of the objects below; it rises when a field changes its meaning, not when one is added.
inline constexpr int fit_json_schema = 1;

/// One fit. `published` maps parameters to the first number published for each, or is null; `verdict` is the
/// worst of theirs; `assessments` lists every published number. Where the fit did not converge the numbers
/// are null.
nlohmann::ordered_json write_fit_json(const FittableFamily& family, const FitReport& report);

/// A mean or limit of fits: the same fields, those without a meaning null.
nlohmann::ordered_json write_derived_json(const Assessment& assessment);

}  // namespace shadefit
