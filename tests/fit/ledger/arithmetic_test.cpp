#include "approx/arithmetic.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(ArithmeticClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(arithmetic_claims, {});
}

}  // namespace
}  // namespace shadefit
