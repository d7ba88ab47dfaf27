#include "app/fit_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/metric_options.hpp"
#include "approx/ledger/catalogue.hpp"
#include "approx/ledger/ledger.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/run/results.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const Published* find_published(const std::string& id) {
  const auto found = std::find_if(published_constants.begin(), published_constants.end(),
                                  [&](const Published& p) { return p.id == id; });
  return found == published_constants.end() ? nullptr : &*found;
}

/// Ids that `fit` takes; a normalisation is named for what it is.
std::vector<std::string> ids_with_a_fit() {
  std::vector<std::string> ids = known_ids();
  std::erase_if(
      ids, [](const std::string& id) { return find_family(id) == nullptr && find_published(id) == nullptr; });
  return ids;
}

std::vector<double> exponents_for(const FittableFamily& family, const Published* published,
                                  const std::optional<std::string>& text) {
  if (!family.has_exponent()) {
    if (!text) return {};
    throw UserError(fmt::format("--exponent '{}' does not apply: {} has no exponent", *text, family.info.id));
  }
  if (!text)
    return published != nullptr ? exponents_needed_by(*published, family.info)
                                : parse_sweep(family.info.sweep);
  try {
    return parse_sweep(*text);
  } catch (const UserError& error) {
    throw UserError(fmt::format("--exponent {}: give K or A:B:STEP, by commas", error.what()));
  }
}

/// A reflectance at normal incidence that leaves something to be fitted.
double parse_f0(const std::string& text) {
  const double f0 = parse_finite("--f0", text);
  if (!(0 <= f0 && f0 < 1))
    throw UserError(
        fmt::format("--f0 '{}' is no reflectance at normal incidence: it must be in [0, 1)", text));
  return f0;
}

}  // namespace

Surface parse_surface(const FittableFamily& family, const FitOptions& options) {
  if (options.target != "schlick" && options.target != "exact") {
    throw UserError(
        fmt::format("--target '{}' is unknown: it must be one of schlick, exact", options.target));
  }
  const bool is_exact = options.target == "exact";
  if (!family.is_fresnel()) {
    const auto refuse = [&](const char* option, const std::string& value) {
      throw UserError(
          fmt::format("{} '{}' does not apply: {} is no Fresnel form", option, value, family.info.id));
    };
    if (is_exact) refuse("--target", options.target);
    if (options.ior) refuse("--ior", *options.ior);
    if (options.extinction) refuse("--extinction", *options.extinction);
    if (options.f0) refuse("--f0", *options.f0);
    return {};
  }
  if (!options.ior && !is_exact) {
    if (options.extinction)
      throw UserError(
          fmt::format("--extinction '{}' does not apply: it belongs to --ior", *options.extinction));
    Surface any;
    if (options.f0) any.f0 = parse_f0(*options.f0);
    return any;
  }
  if (options.f0)
    throw UserError(fmt::format("--f0 '{}' does not apply: a surface of --ior has its own", *options.f0));
  const std::string index = options.ior.value_or("1.5");
  const double ior = parse_finite("--ior", index);
  const double extinction = options.extinction ? parse_finite("--extinction", *options.extinction) : 0;
  if (!(extinction >= 0))
    throw UserError(fmt::format("--extinction '{}' is negative: it must be 0 or more", *options.extinction));
  if (!(ior > 0) || (ior == 1 && extinction == 0))
    throw UserError(fmt::format(
        "--ior '{}' is no index of an interface: it must be greater than 0, and without extinction not 1",
        index));
  const Surface surface{is_exact ? Surface::Formula::exact : Surface::Formula::schlick, ior, extinction,
                        std::nullopt};
  if (!(normal_reflectance<double>(surface) < 1))
    throw UserError(fmt::format(
        "--ior '{}' reflects all light at normal incidence, as doubles have it: no reflectance lies above f0",
        index));
  return surface;
}

std::vector<Setting> settings_for(const FittableFamily& family, const Published* published,
                                  const FitOptions& options) {
  const Surface surface = parse_surface(family, options);
  const auto exponents = exponents_for(family, published, options.exponent);
  if (!family.has_exponent()) return {Setting{0, surface}};
  return {exponents.begin(), exponents.end()};
}

NamedFit find_fit(const std::string& id) {
  const bool is_normalisation = std::any_of(normalisations.begin(), normalisations.end(),
                                            [&](const Normalisation& n) { return n.id == id; });
  if (is_normalisation) {
    throw UserError(fmt::format("'{0}' is integrated, not fitted: see 'shadefit run --only {0}'", id));
  }
  if (find_claim(id) != nullptr && find_family(id) == nullptr && find_published(id) == nullptr) {
    throw UserError(fmt::format("'{0}' is a claim, not fitted: see 'shadefit explain {0}'", id));
  }
  require_known(id, ids_with_a_fit(), "constant to fit");
  const Published* published = find_family(id) == nullptr ? find_published(id) : nullptr;
  return {find_family(published != nullptr ? published->family : std::string_view(id)), published};
}

}  // namespace shadefit
