#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Other kernels.
namespace shadefit {

inline constexpr std::array kernels_claims{
    Claim{
        .id = "other-kernels",
        .statement =
            "a reader asks why not the Gauss-Weierstrass kernel `exp(-x^2/(2t))` or the Abel-Poisson "
            "kernel `(1-t^2)/(1-2tc+t^2)`. We test our own guess, not the reader's: among these kernels "
            "and their forms on the sphere, the spherical Gaussian has the smallest error against `c^k` "
            "at every `k = 3 .. 2048`",
        .inputs = {{"exponents", "3,4,5,8,16,32,64,128,256,512,1024,2048"},
                   {"shown", "3,8,32,256,2048"},
                   {"kernels",
                    "the printed Gauss-Weierstrass,the printed Abel-Poisson,Abel-Poisson on the "
                    "sphere,Gauss-Weierstrass on the sphere"},
                   {"x", "angle"}},
        .derivation =
            "Each kernel, its peak scaled to 1, has its one parameter fitted to c^k: continuous least "
            "squares, uniform in the cosine. c^k is exp(-k(theta^2/2 + theta^4/12 + ..)). A Gaussian of "
            "the angle has no theta^4: its exponent is off by k theta^4/12. The spherical Gaussian is "
            "exp(-k(theta^2/2 - theta^4/24 + ..)): its exponent is off by k theta^4/8. So for sharp lobes "
            "the Gaussian of the angle has 2/3 of the error, but it needs the angle, an arc cosine. With the chord "
            "for x the printed Gaussian is the spherical one. The tails of Abel-Poisson are algebraic.",
        .source = sources::lagarde_2012},
};

}  // namespace shadefit
