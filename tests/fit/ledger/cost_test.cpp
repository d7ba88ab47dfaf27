#include "approx/cost.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(CostClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(cost_claims, {});
}

}  // namespace
}  // namespace shadefit
