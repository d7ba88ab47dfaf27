#include "app/metric_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "app/parse_name.hpp"
#include "fit/scalars/parse_formula.hpp"
#include "fit/solve/weight.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The narrowest domain. A place in it is printed to six digits of the cosine's distance between its ends,
/// and a cosine is rounded to 1.1e-16: a million of these, and no less.
constexpr double narrowest_domain = 1e-10;

/// "A:B" with 0 <= A < B <= 1, not too narrow.
Domain parse_domain(const std::string& text) {
  const auto colon = text.find(':');
  const auto lower = parse_number(std::string_view(text).substr(0, colon));
  const auto upper =
      colon == std::string::npos ? std::nullopt : parse_number(std::string_view(text).substr(colon + 1));
  if (!lower || !upper)
    throw UserError(fmt::format("--domain '{}' is not a pair A:B of finite numbers", text));
  if (!(*lower < *upper))
    throw UserError(fmt::format("--domain '{}' is empty or reversed: A must be less than B", text));
  if (*lower < 0 || *upper > 1)
    throw UserError(fmt::format("--domain '{}' leaves [0, 1]: A and B are cosines", text));
  if (*upper - *lower < narrowest_domain)
    throw UserError(
        fmt::format("--domain '{}' is {:.3g} wide: at least {:g}, a million roundings of a cosine", text,
                    *upper - *lower, narrowest_domain));
  return {*lower, *upper};
}

/// A formula in c that is finite and not negative over the domain, zero at single places only.
std::string parse_weight(const std::string& text, const Domain& domain) {
  if (text.empty()) throw UserError("--weight '' is empty: give a formula in c, such as '1 + 4 c'");
  if (text.size() > longest_formula)
    throw UserError(fmt::format("--weight is {} characters long: at most {}", text.size(), longest_formula));
  try {
    if (const auto fault = find_fault(Weight(text, domain)))
      throw UserError(fmt::format("--weight '{}' {}", text, *fault));
  } catch (const std::invalid_argument& error) {
    throw UserError(fmt::format("--weight: {}", error.what()));
  }
  return text;
}

/// "NAME=VALUE" of a parameter of the family, each once and not all.
std::vector<Held> parse_held(const std::vector<std::string>& texts, const FittableFamily& family) {
  std::vector<Held> held;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    const auto value =
        equals == std::string::npos ? std::nullopt : parse_number(std::string_view(text).substr(equals + 1));
    if (!value) throw UserError(fmt::format("--fix '{}' is not NAME=VALUE with a finite number", text));
    const std::string parameter = text.substr(0, equals);
    const auto& known = family.parameters;
    if (std::find(known.begin(), known.end(), parameter) == known.end())
      throw UserError(fmt::format("--fix '{}': {} has no parameter '{}', it must be one of {}", text,
                                  family.info.id, parameter, fmt::join(known, ", ")));
    if (std::any_of(held.begin(), held.end(), [&](const Held& h) { return h.parameter == parameter; }))
      throw UserError(fmt::format("--fix '{}' gives {} a second time", text, parameter));
    held.push_back({parameter, *value});
  }
  if (held.size() == family.parameters.size())
    throw UserError(fmt::format("--fix '{}' leaves nothing to fit: {} has no other parameter", texts.back(),
                                family.info.id));
  return held;
}

std::optional<double> parse_bound(const std::string& option, const std::optional<std::string>& text) {
  return text ? std::optional(parse_finite(option, *text)) : std::nullopt;
}

Constraints parse_constraints(const FitOptions& options, const FittableFamily& family) {
  Constraints constraints{.held = parse_held(options.fix, family),
                          .at_most = parse_bound("--at-most", options.at_most),
                          .at_least = parse_bound("--at-least", options.at_least)};
  if (options.one_sided)
    constraints.one_sided =
        parse_name("--one-sided", *options.one_sided, std::array{Side::above, Side::below});
  if (constraints.at_most && constraints.at_least && *constraints.at_most < *constraints.at_least)
    throw UserError(fmt::format("--at-least '{}' exceeds --at-most '{}': no value lies between",
                                *options.at_least, *options.at_most));
  for (const std::string& text : options.exact_at) {
    const double c = parse_finite("--exact-at", text);
    auto& places = constraints.exact_at;
    if (std::find(places.begin(), places.end(), c) == places.end()) places.push_back(c);
  }
  return constraints;
}

/// Least squares knows given parameters alone.
void require_minimax(const FitOptions& options) {
  const auto refuse = [&](const char* option, const std::string& value) {
    throw UserError(
        fmt::format("{} '{}' does not apply to least squares: it belongs to --norm minimax", option, value));
  };
  if (!options.exact_at.empty()) refuse("--exact-at", options.exact_at.front());
  if (options.one_sided) refuse("--one-sided", *options.one_sided);
  if (options.at_most) refuse("--at-most", *options.at_most);
  if (options.at_least) refuse("--at-least", *options.at_least);
}

/// The places that count at a setting; a relative error has to have some.
Domain domain_that_counts(const FittableFamily& family, const Setting& setting, const Metric& metric) {
  if (metric.error == Error::absolute) return metric.domain;
  if (family.is_fresnel() && setting.surface.f0 == 0.0 && metric.domain.upper == 1)
    throw UserError(
        "--error 'relative' divides by zero: with --f0 '0' the reflectance F is 0 at c = 1; end the domain "
        "below 1 or raise f0");
  const auto domain = family.relative_domain(setting, metric.domain);
  if (!domain)
    throw UserError(fmt::format(
        "--error 'relative' has no meaning for {} at exponent {} on {}: its target is below 1/255, or that "
        "is below any double",
        family.info.id, setting.exponent, to_text(metric.domain)));
  return *domain;
}

}  // namespace

double parse_finite(const std::string& option, const std::string& text) {
  const auto value = parse_number(text);
  if (!value) throw UserError(fmt::format("{} '{}' is not a finite number", option, text));
  return *value;
}

Metric parse_metric(const FitOptions& options, const FittableFamily& family,
                    std::span<const Setting> settings) {
  Metric metric{.measure = parse_name("--measure", options.measure, measures),
                .norm = parse_name("--norm", options.norm, std::array{Norm::least_squares, Norm::minimax}),
                .error = parse_name("--error", options.error, std::array{Error::absolute, Error::relative})};
  if (options.domain) metric.domain = parse_domain(*options.domain);
  if (options.weight) metric.weight = parse_weight(*options.weight, metric.domain);
  metric.constraints = parse_constraints(options, family);
  if (metric.norm == Norm::least_squares) require_minimax(options);
  for (const Setting& setting : settings) {
    const Domain domain = domain_that_counts(family, setting, metric);
    for (const double c : metric.constraints.exact_at) {
      if (c != domain.lower && c != domain.upper)
        throw UserError(fmt::format("--exact-at '{}' is no end of the domain {} that counts", to_text(c),
                                    to_text(domain)));
    }
  }
  return metric;
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

}  // namespace shadefit
