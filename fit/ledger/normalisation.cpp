#include "approx/normalisation.hpp"

#include "fit/ledger/topics.hpp"

namespace shadefit {

std::span<const Evaluator> normalisation_evaluators() {
  return {};
}

}  // namespace shadefit
