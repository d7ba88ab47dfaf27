#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/options/options.hpp"
#include "approx/records/record.hpp"
#include "fit/fit.hpp"

/// What the options of `fit`, `certify` and their kin mean for a family. Each throws UserError with one line
/// that names the option, its value and the rule.
namespace shadefit {

/// A family, and the published constant by whose id it was asked for, or null.
struct NamedFit {
  const FittableFamily* family;
  const Published* published;
};

/// The ids that `fit` takes: families and published constants.
std::vector<std::string> ids_with_a_fit();

/// The family of an id, its own or that of a published constant.
NamedFit find_fit(const std::string& id);

/// The surface that a Fresnel form is fitted to. Refuses options that would be ignored.
Surface surface_for(const FittableFamily& family, const FitOptions& options);

/// The settings: one for each exponent, or one for the surface.
std::vector<Setting> settings_for(const FittableFamily& family, const Published* published,
                                  const FitOptions& options);

/// The metric of the options, for fits of the family at these settings. Refuses a weight that is no weight on
/// the domain, constraints that contradict each other or leave nothing to fit, and a relative error where the
/// target is zero.
Metric metric_for(const FitOptions& options, const FittableFamily& family, std::span<const Setting> settings);

/// "cosine measure, least squares", or what else the metric says.
std::string headline(const Metric& metric);

}  // namespace shadefit
