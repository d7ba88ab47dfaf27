#include "approx/microfacet.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(MicrofacetClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(microfacet_claims, {});
}

}  // namespace
}  // namespace shadefit
