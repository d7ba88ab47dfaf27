#include "approx/von_mises_fisher.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(VonMisesFisherClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(von_mises_fisher_claims, {});
}

}  // namespace
}  // namespace shadefit
