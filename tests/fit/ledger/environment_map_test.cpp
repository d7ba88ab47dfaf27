#include "approx/environment_map.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(EnvironmentMapClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(environment_map_claims, {});
}

}  // namespace
}  // namespace shadefit
