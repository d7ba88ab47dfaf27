#include "app/options/fit_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "approx/records/optical_constants.hpp"
#include "fit/better/results.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/input/known.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
Surface surface_for(const Family& family, const FitOptions& options) {
  const bool is_exact = options.target == Surface::Formula::exact;
  const auto refuse = [](const char* option, const std::string& value, const std::string& reason) {
    throw UserError(fmt::format("{} '{}' does not apply: {}", option, value, reason));
  };
  if (!family.is_fresnel) {
    const std::string reason = fmt::format("{} is not a Fresnel form", family.id);
    if (options.target) refuse("--target", is_exact ? "exact" : "schlick", reason);
    if (options.ior) refuse("--ior", to_text(*options.ior), reason);
    if (options.extinction) refuse("--extinction", to_text(*options.extinction), reason);
    if (options.f0) refuse("--f0", to_text(*options.f0), reason);
    return {};
  }
  if (!options.ior && !is_exact) {
    if (options.extinction) refuse("--extinction", to_text(*options.extinction), "it belongs to --ior");
    if (options.metric.error == Error::relative && options.f0 == 0.0 && options.metric.domain.upper == 1)
      throw UserError(
          "--error 'relative' divides by zero: with --f0 '0' the reflectance F is 0 at c = 1; end the domain "
          "below 1 or raise f0");
    return {.f0 = options.f0};
  }
  if (options.f0) refuse("--f0", to_text(*options.f0), "a surface of --ior has its own");
  const double ior = options.ior.value_or(constant<double>(glass.ior)),
               extinction = options.extinction.value_or(0);
  if (!(extinction >= 0))
    throw UserError(fmt::format("--extinction '{}' is negative: it must be 0 or more", extinction));
  if (!(ior > 0) || (ior == 1 && extinction == 0))
    throw UserError(fmt::format("--ior '{}' must be greater than 0, and not 1 without --extinction", ior));
  const Surface surface{.formula = is_exact ? Surface::Formula::exact : Surface::Formula::schlick,
                        .ior = ior,
                        .extinction = extinction};
  if (!(normal_reflectance(surface) < 1))
    throw UserError(fmt::format(
        "--ior '{}' reflects all light at normal incidence, to the precision of a double: no reflectance is above f0",
        ior));
  return surface;
}

NamedFit find_fit(const std::string& id) {
  const bool is_normalisation =
      std::ranges::find(normalisations, id, &Normalisation::id) != normalisations.end();
  if (is_normalisation) {
    throw UserError(fmt::format(
        "'{0}' is a normalisation constant, an integral; it is not fitted: see 'shadefit run --only {0}'",
        id));
  }
  if (has_claim(id) && find_family(id) == nullptr && find_published(id) == nullptr) {
    throw UserError(fmt::format("'{0}' is a claim, not fitted: see 'shadefit explain {0}'", id));
  }
  require_known(id, fitted_ids(), "form or constant");
  const Published* published = find_family(id) == nullptr ? find_published(id) : nullptr;
  return {find_family(published != nullptr ? published->family : std::string_view(id)), published};
}

std::string option_of_fits(const std::set<std::string>& present) {
  constexpr std::array all{"--norm",      "--start",   "--bounds",   "--fix",      "--exact-at",
                           "--one-sided", "--at-most", "--at-least", "--monotone", "--round"};
  const auto found = std::ranges::find_if(all, [&](const char* option) { return present.contains(option); });
  return found == all.end() ? "" : *found;
}

}  // namespace shadefit
