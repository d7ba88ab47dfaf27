#include "approx/dither.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(DitherClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(dither_claims, {});
}

}  // namespace
}  // namespace shadefit
