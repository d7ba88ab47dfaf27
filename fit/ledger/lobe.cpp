#include "approx/lobe.hpp"

#include <array>

#include "fit/ledger/published.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

Finding offset_mean(const Claim& claim) {
  return evaluate_published(claim, {"sg-offset-mean"});
}

Finding offset_limit(const Claim& claim) {
  return evaluate_published(claim, {"sg-offset-limit"});
}

Finding offset_at_five(const Claim& claim) {
  return evaluate_published(claim, {"sg-offset-k5"});
}

}  // namespace

std::span<const Evaluator> lobe_evaluators() {
  static constexpr std::array evaluators{Evaluator{"sg-offset-mean", offset_mean},
                                         Evaluator{"sg-offset-limit", offset_limit},
                                         Evaluator{"sg-offset-k5", offset_at_five}};
  return evaluators;
}

}  // namespace shadefit
