#include "approx/material.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(MaterialClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(material_claims, {});
}

}  // namespace
}  // namespace shadefit
