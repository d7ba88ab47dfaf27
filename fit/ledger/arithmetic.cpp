#include "approx/arithmetic.hpp"

#include "fit/ledger/topics.hpp"

namespace shadefit {

std::span<const Evaluator> arithmetic_evaluators() {
  return {};
}

}  // namespace shadefit
