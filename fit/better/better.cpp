#include "fit/better/better.hpp"

#include <algorithm>

#include "approx/fresnel.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/catalogue_study.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

/// The operations of a form with constants in a shader, as `shadefit emit` writes it at one exponent.
/// Expressions of constants alone are precomputed.
Operations executed(const Family& family, const Setting& setting, const std::vector<double>& values) {
  const auto value_of = [&](const std::string& variable) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (family.parameters[i] == variable) return Symbolic::number(to_text(values[i]));
    }
    return variable == "k" ? Symbolic::number(to_text(setting.exponent)) : Symbolic::variable(variable);
  };
  return count_operations(evaluate<Symbolic>(family.form, value_of));
}

ErrorBounds proven_bounds(const StudySubject& subject, double width, const Checkpoint& checkpoint) {
  const auto [certificate, is_reached] = certify_study(subject, width, checkpoint);
  return {certificate.lower, certificate.upper, is_reached};
}

/// The study of a family in its plain formulas of c. Its errors are those of the lobe, or of the reflectance
/// F if a Fresnel form has a surface.
Study plain_study_of(const Family& family, const Setting& setting, Error error, const Domain& domain) {
  Study study;
  if (family.is_fresnel) {
    study = fresnel_study(setting.surface, error);
  } else {
    study.target = to_text(family.target);
    study.given["k"] = to_text(setting.exponent);
    study.error = error;
  }
  study.over = {{"c", to_text(domain.lower), to_text(domain.upper)}};
  study.form = to_text(family.form);
  return study;
}

/// A form with constants and their texts, in the setting of the comparison.
Contender contender(Contender::Kind kind, const Family& family, const Comparison& comparison,
                    const Constants& constants, const std::vector<double>& values, double width,
                    const Checkpoint& checkpoint) {
  const Setting& setting = comparison.setting;
  const Domain& domain = comparison.domain;
  const auto relative = family.max_rel_error(setting, domain, values);
  const StudySubject subject{plain_study_of(family, setting, Error::absolute, domain), constants};
  return {.kind = kind,
          .family = family.id,
          .form = to_text(family.form),
          .parameters = constants,
          .values = values,
          .operations = executed(family, setting, values),
          .max_abs_error = proven_bounds(subject, width, checkpoint),
          .at = family.max_abs_error(setting, domain, values).at,
          .max_rel_error = relative ? std::optional(relative->magnitude) : std::nullopt,
          .rms_error = family.objective(setting, {.domain = domain})(values)};
}

/// Appends the printed constants of a family, each set once.
void append_published(Comparison& comparison, const Family& family, const ComparisonOptions& options,
                      const Checkpoint& checkpoint) {
  auto& contenders = comparison.contenders;
  for (const Published* number : numbers_of(family)) {
    if (number->parameter != family.parameters.front()) continue;  // a set is named by its first number
    Constants constants;
    for (const auto& [parameter, printed] : printed_parameters(family, *number))
      constants.emplace_back(parameter, printed);
    const bool is_known = std::ranges::any_of(contenders, [&](const Contender& other) {
      return other.family == family.id && other.parameters == constants;
    });
    if (is_known) continue;
    Contender found = contender(Contender::Kind::published, family, comparison, constants,
                                published_parameters(family, *number), options.width, checkpoint);
    found.published = number->id;
    found.origin = std::string(number->source.author) + " " + std::to_string(number->source.year);
    contenders.push_back(std::move(found));
  }
}

void append_fit(Comparison& comparison, const Family& family, Metric metric, double width,
                const Checkpoint& checkpoint) {
  metric.domain = comparison.domain;
  Metric everywhere = metric;
  everywhere.domain = {};
  const std::string objective =
      (metric.norm == Norm::minimax ? "" : "least squares, ") + describe(everywhere);
  const Fit fit = family.fit(comparison.setting, metric);
  if (fit.status != Status::converged) {
    comparison.left_out.push_back(to_text(family.form) + " under " + objective + ": " +
                                  std::string(name(fit.status)) + (fit.why.empty() ? "" : ", " + fit.why));
    return;
  }
  Constants constants;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i)
    constants.emplace_back(family.parameters[i], hex_text(fit.parameters[i]));
  Contender found =
      contender(Contender::Kind::fitted, family, comparison, constants, fit.parameters, width, checkpoint);
  found.origin = objective;
  comparison.contenders.push_back(std::move(found));
}

void append_fits(Comparison& comparison, const Family& family, const ComparisonOptions& options,
                 const Checkpoint& checkpoint) {
  const auto append = [&](const Metric& metric) {
    append_fit(comparison, family, metric, options.width, checkpoint);
  };
  append({.norm = Norm::minimax});
  if (options.only_minimax) return;
  append({.norm = Norm::minimax, .error = Error::relative});
  if (family.id != comparison.family->id) return;
  for (const Measure measure : measures) append({.measure = measure});
}

/// Appends Schlick's formula if it is not the target.
void append_schlick(Comparison& comparison, const ComparisonOptions& options, const Checkpoint& checkpoint) {
  const auto study_of = [&](Error error) {
    Study study = plain_study_of(*comparison.family, comparison.setting, error, options.domain);
    study.form = to_text(comparison.family->target);
    return study;
  };
  const Study study = study_of(Error::absolute);
  const ReadStudy absolute = read_formulas(study), relative = read_formulas(study_of(Error::relative));
  const double at = largest_weighted_error(absolute, {}).at.front();
  const Symbolic form = comparison.family->target;
  comparison.contenders.push_back({.kind = Contender::Kind::published,
                                   .published = "schlick",
                                   .form = to_text(form),
                                   .origin = "Schlick 1994",
                                   .operations = count_operations(form),
                                   .max_abs_error = proven_bounds({study, {}}, options.width, checkpoint),
                                   .at = Cosine<double>{at, 1 - at},
                                   .max_rel_error = largest_weighted_error(relative, {}).magnitude,
                                   .rms_error = rms_error(absolute, StudyError(absolute), {})});
}

/// The target as a formula for a shader, with precomputed constants; for an exact surface, the reflectance F.
Symbolic runnable_target(const Family& family, const Surface& surface) {
  if (!surface.is_exact()) return family.target;
  const Symbolic c = Symbolic::variable("c"), n = Symbolic::number(to_text(surface.ior));
  if (surface.extinction == 0) return dielectric_reflectance(c, n);
  return conductor_reflectance(c, n, Symbolic::number(to_text(surface.extinction)));
}

void append_target(Comparison& comparison) {
  const Surface& surface = comparison.setting.surface;
  const std::string text = !surface.is_exact()       ? to_text(comparison.family->target)
                           : surface.extinction == 0 ? "Fresnel's equations of a dielectric"
                                                     : "Fresnel's equations of a conductor";
  comparison.contenders.push_back(
      {.kind = Contender::Kind::target,
       .form = text,
       .origin = "the target itself",
       .operations = count_operations(runnable_target(*comparison.family, surface)),
       .max_rel_error = 0});
}

/// Whether the proven error is smaller at no more instructions.
bool is_better(const Contender& contender, const Contender& published) {
  return contender.max_abs_error.upper < published.max_abs_error.lower &&
         contender.operations.total() <= published.operations.total();
}

}  // namespace

bool have_same_target(const Family& a, const Family& b) {
  return to_text(a.target) == to_text(b.target);
}

Comparison compare_forms(const Family& family, const Setting& setting, const ComparisonOptions& options,
                         const Checkpoint& checkpoint) {
  Comparison comparison{.family = &family, .setting = setting, .domain = options.domain};
  auto& contenders = comparison.contenders;
  if (family.is_fresnel && setting.surface.is_exact()) append_schlick(comparison, options, checkpoint);
  append_target(comparison);
  for (const Family& other : families()) {
    if (!have_same_target(family, other)) continue;
    checkpoint();
    append_published(comparison, other, options, checkpoint);
    append_fits(comparison, other, options, checkpoint);
  }
  std::ranges::stable_sort(contenders, {}, [](const Contender& c) {
    return std::pair(c.kind != Contender::Kind::published, c.max_abs_error.upper);
  });
  for (Contender& contender : contenders) {
    if (contender.kind == Contender::Kind::target) continue;
    for (const Contender& other : contenders) {
      if (other.kind == Contender::Kind::published && is_better(contender, other))
        contender.beats.push_back(other.published);
    }
  }
  return comparison;
}

}  // namespace shadefit
