#include "approx/microfacet.hpp"
#include "approx/ledger/microfacet.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(MicrofacetClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(microfacet_claims, {{"ndf-blinn-phong", "printed 0", "1.00001"},
                                      {"ndf-blinn-phong", "roughness", "0.2"},
                                      {"ndf-blinn-phong", "alpha", "r"},
                                      {"ndf-beckmann", "printed 0", "2"},
                                      {"ndf-beckmann", "roughness", "0.2"},
                                      {"ndf-beckmann", "alpha", "r"},
                                      {"ndf-ggx", "printed 0", "0.99999"},
                                      {"ndf-ggx", "roughness", "0.2"},
                                      {"ndf-ggx", "alpha", "r"},
                                      {"ndf-gtr1", "printed 0", "1.1"},
                                      {"ndf-gtr1", "printed 1", "2/pi"},
                                      {"ndf-gtr1", "printed 1", "0.31831"},
                                      {"ndf-gtr1", "roughness", "0.2"},
                                      {"ndf-gtr1", "alpha", "r"},
                                      {"ndf-gtr1", "distance from alpha = 1", "1e-8"},
                                      {"smith-beckmann", "distribution", "ggx"},
                                      {"smith-beckmann", "masking", "ggx"},
                                      {"smith-beckmann", "roughness", "0.2"},
                                      {"smith-beckmann", "alpha", "r"},
                                      {"smith-beckmann", "view angles", "5,70"},
                                      {"smith-ggx", "distribution", "beckmann"},
                                      {"smith-ggx", "masking", "beckmann"},
                                      {"smith-ggx", "roughness", "0.2"},
                                      {"smith-ggx", "alpha", "r"},
                                      {"smith-ggx", "view angles", "5,70"},
                                      {"smith-borrowed", "blinn-phong", "ggx"},
                                      {"smith-borrowed", "gtr1", "beckmann"},
                                      {"smith-borrowed", "roughness", "0.3,0.6"},
                                      {"smith-borrowed", "alpha", "r"},
                                      {"smith-borrowed", "view angles", "5,70"},
                                      {"smith-borrowed", "accurate", "0.05"}});
}

}  // namespace
}  // namespace shadefit
