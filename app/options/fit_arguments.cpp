#include "app/options/fit_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "approx/records/optical_constants.hpp"
#include "fit/better/results.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/input/known.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/quadrature/fit_rules.hpp"
#include "fit/rounding/round_family.hpp"
#include "fit/study/require_values.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

std::vector<double> exponents_for(const Family& family, const Published* published,
                                  const std::optional<std::vector<double>>& exponents) {
  if (!family.has_exponent()) {
    if (!exponents) return {};
    throw UserError(fmt::format("--exponent '{}' does not apply: {} has no exponent",
                                fmt::join(*exponents, ","), family.id));
  }
  if (exponents) return *exponents;
  return published != nullptr ? exponents_needed_by(*published, family) : parse_sweep(family.sweep);
}

/// Refuses a weight that is not finite or negative on the domain.
void check_weight(const std::string& text, const Domain& domain) {
  const ReadStudy read = read_formulas({.target = "c",
                                        .form = "c",
                                        .over = {{"c", to_text(domain.lower), to_text(domain.upper)}},
                                        .weight = text});
  for (const double end : {domain.lower, domain.upper}) {
    const double value = evaluate<double>(read.weight, [&](const std::string&) { return end; });
    if (!std::isfinite(value))
      throw UserError(
          fmt::format("--weight '{}' is {} at c = {}: it must be finite over the domain", text, value, end));
  }
  require_values(read, nodes_of(read, edges_of(read), fit_rules.back()));
}

/// Requires that each is a parameter of the family, given once, and that one parameter is left to fit.
void check_held(const std::vector<Held>& held, const Family& family) {
  const auto text = [](const Held& h) { return h.parameter + "=" + to_text(h.value); };
  const auto& known = family.parameters;
  for (auto h = held.begin(); h != held.end(); ++h) {
    if (std::ranges::find(known, h->parameter) == known.end())
      throw UserError(fmt::format("--fix '{}': {} has no parameter '{}', it must be one of {}", text(*h),
                                  family.id, h->parameter, fmt::join(known, ", ")));
    if (std::any_of(held.begin(), h, [&](const Held& other) { return other.parameter == h->parameter; }))
      throw UserError(fmt::format("--fix '{}' gives {} a second time", text(*h), h->parameter));
  }
  if (held.size() == known.size())
    throw UserError(fmt::format("--fix '{}' leaves nothing to fit: {} has no other parameter",
                                text(held.back()), family.id));
}

/// The first constraint that a least-squares fit does not support, as option and value.
std::optional<std::pair<const char*, std::string>> constraint_for_minimax(const Constraints& constraints) {
  if (!constraints.exact_at.empty()) return {{"--exact-at", to_text(constraints.exact_at.front())}};
  if (constraints.one_sided) return {{"--one-sided", std::string(name(*constraints.one_sided))}};
  if (constraints.at_most) return {{"--at-most", to_text(*constraints.at_most)}};
  if (constraints.at_least) return {{"--at-least", to_text(*constraints.at_least)}};
  return std::nullopt;
}

/// The cosines that count at a setting; a relative error must be defined at some of them.
Domain domain_that_counts(const Family& family, const Setting& setting, const Metric& metric) {
  if (metric.error == Error::absolute) return metric.domain;
  if (family.is_fresnel && setting.surface.f0 == 0.0 && metric.domain.upper == 1)
    throw UserError(
        "--error 'relative' divides by zero: with --f0 '0' the reflectance F is 0 at c = 1; end the domain "
        "below 1 or raise f0");
  const auto domain = family.relative_domain(setting, metric.domain);
  if (!domain)
    throw UserError(fmt::format(
        "--error 'relative' has no meaning for {} at exponent {} on {}: its target is below 1/255, or that "
        "is below any double",
        family.id, setting.exponent, to_text(metric.domain)));
  return *domain;
}

/// The published number for a parameter of a fit: from the requested record, else the first number that is a
/// best fit in that setting.
const Published* published_for(const Family& family, std::string_view parameter, const Setting& setting,
                               const Published* asked) {
  if (asked != nullptr && asked->parameter == parameter) return asked;
  for (const Published& p : published_constants()) {
    if (p.family != family.id || p.parameter != parameter || p.statement != Statement::best_fit) continue;
    if (!family.has_exponent() || exponents_of(p) == std::vector{setting.exponent}) return &p;
  }
  return nullptr;
}

}  // namespace

void refuse_minimax_constraints(const Constraints& constraints) {
  if (const auto found = constraint_for_minimax(constraints))
    throw UserError(fmt::format("{} '{}' does not apply to least squares: it belongs to --norm minimax",
                                found->first, found->second));
}

Surface surface_for(const Family& family, const FitOptions& options) {
  const bool is_exact = options.target == Surface::Formula::exact;
  const auto refuse = [](const char* option, const std::string& value, const std::string& reason) {
    throw UserError(fmt::format("{} '{}' does not apply: {}", option, value, reason));
  };
  if (!family.is_fresnel) {
    const std::string reason = fmt::format("{} is not a Fresnel form", family.id);
    if (is_exact) refuse("--target", "exact", reason);
    if (options.ior) refuse("--ior", to_text(*options.ior), reason);
    if (options.extinction) refuse("--extinction", to_text(*options.extinction), reason);
    if (options.f0) refuse("--f0", to_text(*options.f0), reason);
    return {};
  }
  if (!options.ior && !is_exact) {
    if (options.extinction) refuse("--extinction", to_text(*options.extinction), "it belongs to --ior");
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
  if (!(normal_reflectance<double>(surface) < 1))
    throw UserError(fmt::format(
        "--ior '{}' reflects all light at normal incidence, to the precision of a double: no reflectance is above f0",
        ior));
  return surface;
}

std::vector<Setting> settings_for(const Family& family, const Published* published,
                                  const FitOptions& options) {
  const Surface surface = surface_for(family, options);
  const auto exponents = exponents_for(family, published, options.exponents);
  if (!family.has_exponent()) return {Setting{0, surface}};
  return {exponents.begin(), exponents.end()};
}

Metric metric_for(const FitOptions& options, const Family& family, std::span<const Setting> settings) {
  Metric metric = options.metric;
  auto& places = metric.constraints.exact_at;
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const Constraints& constraints = metric.constraints;
  if (!metric.weight.empty()) check_weight(metric.weight, metric.domain);
  if (!constraints.held.empty()) check_held(constraints.held, family);
  if (constraints.at_most && constraints.at_least && *constraints.at_most < *constraints.at_least)
    throw UserError(fmt::format("--at-least '{}' exceeds --at-most '{}': no value is between",
                                *constraints.at_least, *constraints.at_most));
  const auto for_minimax = constraint_for_minimax(constraints);
  if (metric.norm == Norm::least_squares) refuse_minimax_constraints(constraints);
  if (options.sensitivity && for_minimax)
    throw UserError(
        fmt::format("{} '{}' does not go with --sensitivity: constants that are rounded do not keep to it",
                    for_minimax->first, for_minimax->second));
  for (const Setting& setting : settings) {
    const Domain domain = domain_that_counts(family, setting, metric);
    for (const double c : constraints.exact_at) {
      if (c != domain.lower && c != domain.upper)
        throw UserError(
            fmt::format("--exact-at '{}' is not an end of the domain {}", to_text(c), to_text(domain)));
    }
  }
  return metric;
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

std::string headline(const Metric& metric) {
  if (metric.norm == Norm::minimax)
    return describe(metric) +
           fmt::format("; the {} measure counts for the rms error alone", name(metric.measure));
  const bool is_plain =
      metric.error == Error::absolute && metric.weight.empty() && metric.constraints == Constraints{};
  return is_plain ? describe(metric) + " measure, least squares"
                  : "least squares, measure: " + describe(metric);
}

std::string option_of_fits(const std::set<std::string>& present) {
  constexpr std::array all{"--norm",      "--start",   "--bounds",   "--fix",      "--exact-at",
                           "--one-sided", "--at-most", "--at-least", "--monotone", "--round"};
  const auto found = std::ranges::find_if(all, [&](const char* option) { return present.contains(option); });
  return found == all.end() ? "" : *found;
}

std::string words_of_rounding(const NumberFormat& format) {
  return "the smallest largest error of constants in " + to_text(format);
}

ChosenSubject chosen_constants(const std::optional<Parameters>& parameters, const NamedFit& named,
                               const Setting& setting, const Metric& metric, const FitOptions& options,
                               const Checkpoint& checkpoint) {
  const Family& family = *named.family;
  const bool has_weight = options.present.contains("--weight");  // no proof of a family has one
  const std::string asks_for_fit = has_weight ? "--weight" : option_of_fits(options.present);
  if (parameters && !asks_for_fit.empty())
    throw UserError(fmt::format("{} does not go with --parameters: nothing is fitted", asks_for_fit));
  FamilySubject subject{std::string(family.id), {}, setting, metric.error, metric.domain};
  if (parameters) {
    const std::vector<std::string> known(family.parameters.begin(), family.parameters.end());
    subject.parameters = in_order(*parameters, known);
    return {subject, "given"};
  }
  for (const std::string_view parameter : family.parameters) {
    const Published* p = published_for(family, parameter, setting, named.published);
    if (asks_for_fit.empty() && p != nullptr) subject.parameters.emplace_back(parameter, p->printed);
  }
  if (subject.parameters.size() == family.parameters.size()) return {subject, "published"};
  const Fit fit = family.fit(setting, metric);
  if (fit.status != Status::converged) {
    throw UserError(fmt::format("{}{}: its fit did not converge{}: give --parameters", family.id,
                                family.has_exponent() ? fmt::format(" at exponent {}", setting.exponent) : "",
                                fit.why.empty() ? "" : fmt::format(" ({})", fit.why)));
  }
  subject = subject_of(fit, metric.error);
  if (options.round) {
    const std::vector<std::string> texts = round_fit(fit, *options.round, {}, checkpoint).best.texts;
    for (std::size_t i = 0; i < texts.size(); ++i) subject.parameters[i].second = texts[i];
  }
  return {subject, "fitted"};
}

}  // namespace shadefit
