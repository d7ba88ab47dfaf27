#include "approx/phong_blinn.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(PhongBlinnClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(phong_blinn_claims, {});
}

}  // namespace
}  // namespace shadefit
