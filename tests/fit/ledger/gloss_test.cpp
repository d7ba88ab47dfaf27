#include "approx/gloss.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(GlossClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(gloss_claims, {});
}

}  // namespace
}  // namespace shadefit
