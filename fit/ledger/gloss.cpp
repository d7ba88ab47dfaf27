#include "approx/gloss.hpp"

#include "fit/ledger/topics.hpp"

namespace shadefit {

std::span<const Evaluator> gloss_evaluators() {
  return {};
}

}  // namespace shadefit
