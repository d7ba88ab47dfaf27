#include "approx/fresnel.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(FresnelClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(fresnel_claims, {});
}

}  // namespace
}  // namespace shadefit
