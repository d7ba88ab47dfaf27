#pragma once

#include <string>
#include <vector>

#include "app/commands.hpp"
#include "approx/records/record.hpp"
#include "fit/fit.hpp"

/// What the arguments of `fit` and `certify` name. Each throws UserError for what they do not.
namespace shadefit {

/// A family, and the published constant by whose id it was asked for, or null.
struct NamedFit {
  const FittableFamily* family;
  const Published* published;
};

/// The family of an id, its own or that of a published constant.
NamedFit find_fit(const std::string& id);

/// The surface that a Fresnel form is fitted to; refuses what would be ignored.
Surface parse_surface(const FittableFamily& family, const FitOptions& options);

/// The settings: one for each exponent, or one for the surface.
std::vector<Setting> settings_for(const FittableFamily& family, const Published* published,
                                  const FitOptions& options);

}  // namespace shadefit
