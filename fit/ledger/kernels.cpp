#include "approx/kernels.hpp"

#include "fit/ledger/topics.hpp"

namespace shadefit {

std::span<const Evaluator> kernels_evaluators() {
  return {};
}

}  // namespace shadefit
