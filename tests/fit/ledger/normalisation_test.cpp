#include "approx/normalisation.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(NormalisationClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(normalisation_claims, {});
}

}  // namespace
}  // namespace shadefit
