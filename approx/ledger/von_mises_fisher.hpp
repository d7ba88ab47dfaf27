#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: von Mises-Fisher.
namespace shadefit {

inline constexpr std::array von_mises_fisher_claims{
    Claim{.id = "vmf-normalisation",
          .statement = "`k/(4 pi sinh k)` `e^(k c)` integrates to 1 over the sphere",
          .printed = {{"", "1"}},
          .inputs = {{"exponents", "0.001,0.01,0.1,1,2,10,100,1000,10000,100000"}},
          .derivation =
              "2 pi times the integral of e^(k c) over c in [-1, 1] is 4 pi sinh(k)/k. It is integrated as "
              "k/(2 pi (1 - e^(-2k))) e^(-k y), which is the same and never overflows, over t = k y up to "
              "48. The rest is less than e^(-48).",
          .source = sources::lagarde_2012},
    Claim{.id = "vmf-large-k",
          .statement = "for `k > 2` the density is about `k/(2 pi)` `e^(-k(1-c))`",
          .printed = {{"k", "2"}},
          .inputs = {{"about", "0.02"}, {"no longer about", "0.05"}, {"y", "0.001,1,2"}},
          .derivation =
              "sinh k = e^k (1 - e^(-2k))/2, so the ratio of this to the density is 1 - e^(-2k) at every "
              "angle. It is too small by e^(-2k) of its value, most at the smallest k. We read \"about\" as "
              "within 2 %, which holds from k = ln(50)/2 on. A smaller k would be `conditional`, as the "
              "claim then holds only from there on, and `refuted` where more than 5 % are missing.",
          .source = sources::lagarde_2012},
};

}  // namespace shadefit
