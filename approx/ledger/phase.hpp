#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Phase functions.
namespace shadefit {

inline constexpr std::array phase_claims{
    Claim{.id = "hg-normalisation",
          .statement =
              "the Henyey-Greenstein function `(1-g^2)/(4 pi (1+g^2-2 g c)^1.5)`, as written in the loop, "
              "integrates to 1 over the sphere",
          .printed = {{"integral", "1"}},
          .inputs = {{"g", "-0.999, -0.99, -0.9, -0.5, 0, 0.2, 0.5, 0.76, 0.9, 0.99, 0.999"}},
          .derivation =
              "In c the function is the derivative of (1-g^2)/(4 pi g) (1+g^2-2 g c)^(-1/2): from c = -1 to "
              "1 and times 2 pi, (1-g^2)/(2g) (1/(1-g) - 1/(1+g)) = 1 for every |g| < 1. Two quadrature "
              "rules integrate it too, in s with 1-c = (1-g)^2/(2g) (exp(s)-1), which stretches the peak, "
              "and in the angle. The printed form is evaluated in single precision against 1+g^2-2 g c = "
              "(1-g)^2 + 2 g (1-c), which does not cancel.",
          .source = sources::henyey_greenstein_1941},
};

}  // namespace shadefit
