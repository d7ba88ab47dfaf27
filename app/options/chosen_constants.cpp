#include "app/options/chosen_constants.hpp"

#include <fmt/format.h>

#include <vector>

#include "approx/ledger/catalogue.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

/// The published number for a parameter of a fit: from the requested record, else the first number that is a
/// best fit in that setting.
const Published* published_for(const FittableFamily& family, std::string_view parameter,
                               const Setting& setting, const Published* asked) {
  if (asked != nullptr && asked->parameter == parameter) return asked;
  for (const Published& p : published_constants) {
    if (p.family != family.info.id || p.parameter != parameter || p.statement != Statement::best_fit)
      continue;
    if (!family.has_exponent() || exponents_of(p) == std::vector{setting.exponent}) return &p;
  }
  return nullptr;
}

}  // namespace

ChosenSubject chosen_constants(const std::optional<Parameters>& parameters, const NamedFit& named,
                               const Setting& setting, const Metric& metric) {
  const FittableFamily& family = *named.family;
  Subject subject{std::string(family.info.id), {}, setting, metric.error, metric.domain};
  if (parameters) {
    const std::vector<std::string> known(family.parameters.begin(), family.parameters.end());
    subject.parameters = in_order(*parameters, known);
    return {subject, "given"};
  }
  for (const std::string_view parameter : family.parameters) {
    if (const Published* p = published_for(family, parameter, setting, named.published))
      subject.parameters.emplace_back(parameter, p->printed);
  }
  if (subject.parameters.size() == family.parameters.size()) return {subject, "published"};
  const Fit fit = family.fit(setting, metric);
  if (fit.status != Status::converged) {
    throw UserError(fmt::format(
        "{}{}: nothing was published for it and its fit did not converge{}: give --parameters",
        family.info.id, family.has_exponent() ? fmt::format(" at exponent {}", setting.exponent) : "",
        fit.why.empty() ? "" : fmt::format(" ({})", fit.why)));
  }
  return {subject_of(fit, metric.error), "fitted"};
}

}  // namespace shadefit
