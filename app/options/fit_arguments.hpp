#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/options/options.hpp"
#include "approx/records/record.hpp"
#include "fit/bounds/family_subject.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/support/checkpoint.hpp"

/// Interprets the options of `fit`, `certify` and similar commands for a family. Each function throws
/// UserError with one line that names the option, its value and the rule.
namespace shadefit {

/// A family, and the published constant whose id was given, or null.
struct NamedFit {
  const Family* family;
  const Published* published;
};

/// Throws UserError for a constraint that only minimax supports.
void refuse_minimax_constraints(const Constraints& constraints);

/// The family of an id: the id of a family or of a published constant.
NamedFit find_fit(const std::string& id);

/// The surface that a Fresnel form is fitted to. Refuses options that it would otherwise ignore.
Surface surface_for(const Family& family, const FitOptions& options);

/// The settings: one for each exponent, or one for the surface.
std::vector<Setting> settings_for(const Family& family, const Published* published,
                                  const FitOptions& options);

/// The metric of the options, for fits of the family at these settings. Refuses a weight that is invalid on
/// the domain, constraints that contradict each other or leave nothing to fit, and a relative error where the
/// target is zero.
Metric metric_for(const FitOptions& options, const Family& family, std::span<const Setting> settings);

/// The metric as text: "cosine measure, least squares".
std::string headline(const Metric& metric);

/// The constants of a form that `certify` and `emit` use.
struct ChosenSubject {
  FamilySubject subject;
  std::string_view from;  ///< the origin of its values: given, published or fitted
};

/// The first of these options that counts for a fit alone, as a text; empty without any.
std::string option_of_fits(const std::set<std::string>& present);

/// "the smallest largest error of constants in half": what --round looks for.
std::string words_of_rounding(const NumberFormat& format);

/// The given `parameters`; without them the parameters published for that setting, unless an option of a fit
/// is present; if one of these is missing, those of a fit, rounded if that is asked. Throws UserError if the
/// fit did not converge.
ChosenSubject chosen_constants(const std::optional<Parameters>& parameters, const NamedFit& named,
                               const Setting& setting, const Metric& metric, const FitOptions& options,
                               const Checkpoint& checkpoint);

}  // namespace shadefit
