#include "approx/harmonics.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(HarmonicsClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(harmonics_claims, {});
}

}  // namespace
}  // namespace shadefit
