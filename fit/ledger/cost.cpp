#include "approx/cost.hpp"

#include "fit/ledger/topics.hpp"

namespace shadefit {

std::span<const Evaluator> cost_evaluators() {
  return {};
}

}  // namespace shadefit
