#include "fit/ledger/ledger.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "approx/ledger/ledger.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/published.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {

namespace {

/// The function that computes the claim, or null.
Evaluate evaluator_of(const Claim& claim) {
  const std::array topics{
      lobe_evaluators(),          gloss_evaluators(),
      arithmetic_evaluators(),    cost_evaluators(),
      kernels_evaluators(),       von_mises_fisher_evaluators(),
      fresnel_evaluators(),       phong_blinn_evaluators(),
      normalisation_evaluators(), environment_map_evaluators(),
      harmonics_evaluators(),     material_evaluators(),
      phase_evaluators(),         dither_evaluators(),
      microfacet_evaluators(),
  };
  for (const auto& evaluators : topics) {
    for (const Evaluator& evaluator : evaluators) {
      if (evaluator.id == claim.id) return evaluator.evaluate;
    }
  }
  return nullptr;
}

}  // namespace

Finding evaluate(const Claim& claim, Fits& fits) {
  const Evaluate evaluate_claim = evaluator_of(claim);
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

std::vector<JudgedClaim> judge_claims(const std::function<bool(std::string_view id)>& is_wanted, Fits& fits,
                                      const Checkpoint& checkpoint) {
  std::vector<JudgedClaim> judged;
  for (const Topic& topic : ledger) {
    for (const Claim& claim : topic.claims) {
      if (!is_wanted(claim.id)) continue;
      checkpoint();
      judged.push_back({&topic, &claim, evaluate(claim, fits)});
    }
  }
  return judged;
}

const Claim* find_claim(std::string_view id) {
  for (const Topic& topic : ledger) {
    for (const Claim& claim : topic.claims) {
      if (claim.id == id) return &claim;
    }
  }
  return nullptr;
}

}  // namespace shadefit
