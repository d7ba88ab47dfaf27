#include "approx/phase.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(PhaseClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(phase_claims, {});
}

}  // namespace
}  // namespace shadefit
