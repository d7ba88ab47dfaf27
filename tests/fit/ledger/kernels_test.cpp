#include "approx/kernels.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(KernelsClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(kernels_claims, {});
}

}  // namespace
}  // namespace shadefit
