#include "fit/ledger/published.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/ledger/catalogue.hpp"
#include "fit/errors/effect.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/sweep.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

/// The record of that id, saying what the claim says.
Published as_claimed(std::string_view id, const Claim& claim, std::string_view printed) {
  for (Published record : published_constants) {
    if (record.id != id) continue;
    record.printed = printed;
    for (const Quantity& input : claim.inputs) {
      if (input.name == "exponents") record.exponents = input.value;
    }
    return record;
  }
  throw std::logic_error("no published constant " + std::string(id));
}

/// "0.7753642585 under the cosine measure, .."
std::string under_each_measure(FitCache& fits, const Published& published, const Domain& domain) {
  std::vector<std::string> values;
  for (const Measure measure : measures) {
    const auto value = computed_value(fits, published, {.measure = measure, .domain = domain});
    values.push_back((value ? decimal(*value, 10) : "no value") + " under the " + std::string(name(measure)) +
                     " measure");
  }
  return enumerated(values);
}

std::string what_is_computed(const Published& published) {
  const std::string best = "the best " + std::string(published.parameter);
  switch (published.statement) {
    case Statement::best_fit:
      return best + (published.exponents.empty() ? "" : " at k = " + std::string(published.exponents));
    case Statement::mean_of_fits:
      return "the mean of " + best + " over k = " + std::string(published.exponents);
    case Statement::limit_of_fits:
      return "the limit of " + best;
    case Statement::fit_somewhere:
      return best + " takes the printed value";
  }
  throw std::logic_error("a statement without words");
}

/// Of a number that was printed without its exponent: what it does in the place of the best one, at the worst
/// exponents of the family's sweep.
std::string effect_elsewhere(FitCache& fits, const Published& published, const Metric& metric) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  Effect worst;
  for (const double exponent : parse_sweep(fits.family().info.sweep)) {
    const Fit& fit = fits.at(exponent, metric);
    if (fit.status != Status::converged) continue;
    auto from = fit.parameters;
    from[parameter] = number_of(published.printed);
    worst.include(fits.family().effect(exponent, metric.domain, from, fit.parameters), {"k = ", exponent});
  }
  return sentence(worst, "the curve", "in the place of the best one it");
}

/// One printed number: its verdict and its part of the sentence.
Finding evaluate_part(FitCache& fits, const Published& published, const Domain& domain) {
  const auto assessment = assess(fits, published, {.domain = domain});
  if (!assessment)
    return {std::nullopt, "", what_is_computed(published) + " rests on fits that did not converge", "none"};
  Finding finding{assessment->judgement.verdict, decimal(assessment->judgement.value, 10),
                  what_is_computed(published), sentence(assessment->effect)};
  if (published.statement == Statement::fit_somewhere) {
    const auto& range = assessment->holds_for;
    finding.evidence += range ? " at k = " + decimal(range->exactly, 3) +
                                    " and rounds to it from k = " + decimal(range->from, 3) + " to " +
                                    decimal(range->to, 3) + " under the cosine measure"
                              : " at no exponent of the sweep";
    // of a number without its exponent the computed thing is where it is right
    finding.computed = range ? "the best from k = " + decimal(range->from, 3) + " to " + decimal(range->to, 3)
                             : "the best at no k";
    finding.effect = effect_elsewhere(fits, published, assessment->metric);
  } else {
    finding.evidence += " is " + under_each_measure(fits, published, domain);
  }
  if (finding.verdict == Verdict::other_objective)
    finding.evidence += "; the printed digits are those of: " + assessment->judgement.objective;
  return finding;
}

}  // namespace

Finding evaluate_published(const Claim& claim, std::initializer_list<std::string_view> published_ids) {
  if (claim.printed.size() != published_ids.size()) throw std::logic_error("a number without its record");
  const Domain domain{given(claim, "from"), given(claim, "to")};
  std::vector<std::optional<Verdict>> found;
  std::vector<std::string> computed, evidence, effects;
  std::size_t i = 0;
  for (const std::string_view id : published_ids) {
    const Quantity& printed = claim.printed[i++];
    const Published published = as_claimed(id, claim, printed.value);
    FitCache fits(*find_family(published.family));
    const Finding part = evaluate_part(fits, published, domain);
    found.push_back(part.verdict);
    computed.push_back((printed.name.empty() ? "" : std::string(printed.name) + " = ") + part.computed);
    evidence.push_back(part.evidence);
    effects.push_back(part.effect == "none" || printed.name.empty()
                          ? part.effect
                          : std::string(printed.name) + ": " + part.effect);
  }
  const auto joined = [](const std::vector<std::string>& parts, const char* between) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : between) + part;
    return out;
  };
  return {worst(found), joined(computed, ", "), joined(evidence, "; "), sentences(effects)};
}

}  // namespace shadefit
