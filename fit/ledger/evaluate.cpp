#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/computation.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// The record with the printed number and the exponents of the claim, which a test may change.
Published as_claimed(Published record, const Claim& claim, std::string_view printed) {
  record.printed = printed;
  for (const Quantity& input : claim.inputs) {
    if (input.name == "exponents") record.exponents = input.value;
  }
  return record;
}

/// "0.7753642585 under the cosine measure, .."
std::string under_each_measure(FitCache& fits, const Published& published, const Domain& domain) {
  std::vector<std::string> values;
  for (const Measure measure : measures) {
    const auto value = computed_value(fits, published, {.measure = measure, .domain = domain});
    values.push_back(
        fmt::format("{} under the {} measure", value ? decimal(*value, 10) : "no value", name(measure)));
  }
  return enumerated(values);
}

std::string what_is_computed(const Published& published) {
  const std::string best = fmt::format("the best {}", published.parameter);
  switch (published.statement) {
    case Statement::best_fit:
      return best + (published.exponents.empty() ? "" : fmt::format(" at k = {}", published.exponents));
    case Statement::mean_of_fits:
      return fmt::format("the mean of {} over k = {}", best, published.exponents);
    case Statement::limit_of_fits:
      return fmt::format("the limit of {}", best);
    case Statement::fit_somewhere:
      return fmt::format("{} takes the printed value", best);
  }
  throw std::logic_error("a statement without words");
}

/// For a number that was printed without its exponent: the effect of using it instead of the best, at the
/// worst exponents of the family's sweep.
std::string effect_elsewhere(FitCache& fits, const Published& published, const Metric& metric) {
  const std::size_t parameter = parameter_index(fits.family(), published.parameter);
  Effect worst;
  for (const double exponent : parse_sweep(fits.family().sweep)) {
    const Fit& fit = fits.at(exponent, metric);
    if (fit.status != Status::converged) continue;
    auto from = fit.parameters;
    from[parameter] = number_of(published.printed);
    worst.include(fits.family().effect(exponent, metric.domain, from, fit.parameters), {"k = ", exponent});
  }
  return sentence(worst, "the curve", "using the best number instead of the printed one");
}

/// One printed number: its verdict and its part of the sentence.
Finding evaluate_part(FitCache& fits, const Published& published, const Domain& domain) {
  const auto assessment = assess(fits, published, {.domain = domain});
  if (!assessment)
    return {std::nullopt, "",
            fmt::format("{} rests on fits that did not converge", what_is_computed(published)), "none"};
  Finding finding{
      assessment->judgement.verdict, decimal(assessment->judgement.value, 10), what_is_computed(published),
      sentence(assessment->effect, "the curve", "using the computed number instead of the printed one")};
  if (published.statement == Statement::fit_somewhere) {
    const auto& range = assessment->holds_for;
    finding.evidence +=
        range ? fmt::format(
                    " at k = {:.3g} under the cosine measure, and rounds to it from k = {:.3g} to {:.3g}",
                    range->exactly, range->from, range->to)
              : " at no exponent of the sweep";
    // for a number without its exponent, the computed text names the exponents where it is right
    finding.computed =
        range ? fmt::format("the best number, rounded, for k from {:.3g} to {:.3g}", range->from, range->to)
              : "the best at no k";
    finding.effect = effect_elsewhere(fits, published, assessment->metric);
  } else {
    finding.evidence += fmt::format(" is {}", under_each_measure(fits, published, domain));
  }
  if (finding.verdict == Verdict::other_objective)
    finding.evidence += fmt::format(". The printed digits are those of another objective: {}",
                                    assessment->judgement.objective);
  return finding;
}

/// Judges the printed numbers of a claim like its published constants: by fits on the domain of the inputs
/// `from` and `to`, over the input `exponents` if the claim has one.
Finding evaluate_published(const Claim& claim, Fits& fits) {
  const Domain domain{given(claim, "from"), given(claim, "to")};
  std::vector<std::optional<Verdict>> found;
  std::vector<std::string> computed, evidence, effects;
  std::size_t i = 0;
  for (const Published& record : claim.constants) {
    const Quantity& printed = claim.printed[i++];
    const Published published = as_claimed(record, claim, printed.value);
    const Finding part = evaluate_part(fits.of(*find_family(published.family)), published, domain);
    found.push_back(part.verdict);
    computed.push_back(fmt::format("{} = {}", printed.name, part.computed));
    evidence.push_back(part.evidence);
    effects.push_back(part.effect == "none" ? "none" : fmt::format("{}: {}", printed.name, part.effect));
  }
  return {worst(found), fmt::format("{}", fmt::join(computed, ", ")), sentences(evidence),
          sentences(effects)};
}

/// The function that computes the claim, or null.
Evaluate evaluator_of(const Claim& claim) {
  static constexpr std::array topics{lobe_evaluators,    half_banding_evaluators,  cost_evaluators,
                                     kernels_evaluators, normalisation_evaluators, microfacet_evaluators};
  for (const auto& evaluators : topics) {
    for (const Evaluator& evaluator : evaluators()) {
      if (evaluator.id == claim.id) return evaluator.evaluate;
    }
  }
  return nullptr;
}

}  // namespace

Finding evaluate(const Claim& claim, Fits& fits) {
  const bool is_data = !claim.instructions.verdicts.empty();
  const Evaluate evaluate_claim = is_data ? computed_by_its_record : evaluator_of(claim);
  if (claim.constants.empty()) {
    if (evaluate_claim == nullptr)
      throw std::logic_error("nothing computes the claim " + std::string(claim.id));
    return evaluate_claim(claim);
  }
  Finding finding = evaluate_published(claim, fits);
  if (evaluate_claim != nullptr) {
    const Finding further = evaluate_claim(claim);
    finding.verdict = worst(std::array{finding.verdict, further.verdict});
    finding.evidence = sentences({finding.evidence, further.evidence});
  }
  return finding;
}

}  // namespace shadefit
