#include "approx/lobe.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(LobeClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(lobe_claims, {{"sg-offset-mean", "printed 0", "0.778"},
                                {"sg-offset-mean", "exponents", "3:9:1"},
                                {"sg-offset-mean", "from", "0.1"},
                                {"sg-offset-mean", "to", "0.9"},
                                {"sg-offset-limit", "printed 0", "0.78"},
                                {"sg-offset-limit", "from", "0.999"},
                                {"sg-offset-limit", "to", "0.9"},
                                {"sg-offset-k5", "printed 0", "0.785"},
                                {"sg-offset-k5", "exponents", "6"},
                                {"sg-offset-k5", "from", "0.1"},
                                {"sg-offset-k5", "to", "0.9"}});
}

TEST(LobeClaims, EveryDigitMatters) {
  for (const char* id : {"sg-offset-mean", "sg-offset-limit", "sg-offset-k5"})
    check_every_digit(*find_claim(id));
}

}  // namespace
}  // namespace shadefit
