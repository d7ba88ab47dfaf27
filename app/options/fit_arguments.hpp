#pragma once

#include <string>

#include "app/options/options.hpp"
#include "approx/records/record.hpp"
#include "fit/catalogue/family.hpp"

/// Interprets the options of `fit`, `certify` and similar commands for a family. Each function throws
/// UserError with one line that names the option, its value and the rule.
namespace shadefit {

/// A family, and the published constant whose id was given, or null.
struct NamedFit {
  const Family* family;
  const Published* published;
};

/// The family of an id: the id of a family or of a published constant.
NamedFit find_fit(const std::string& id);

/// The surface that a Fresnel form is fitted to. Refuses options that it would otherwise ignore.
Surface surface_for(const Family& family, const FitOptions& options);

/// The first of these options that counts for a fit alone, as a text; empty without any.
std::string option_of_fits(const std::set<std::string>& present);

}  // namespace shadefit
