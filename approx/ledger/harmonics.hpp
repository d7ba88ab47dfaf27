#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Spherical harmonics.
namespace shadefit {

inline constexpr std::array harmonics_claims{
    Claim{.id = "sh-basis",
          .statement =
              "the real spherical harmonics of bands 0 and 1 are 0.282095 and 0.488603 times `-y`, `z` and "
              "`-x`",
          .printed = {{"band 0", "0.282095"}, {"band 1", "0.488603"}},
          .inputs = {{"tolerance", "1e-12"}},
          .derivation =
              "The integral of 1 over the sphere is 4 pi, that of z^2 a third of it, so the factors of unit "
              "norm are sqrt(1/(4 pi)) and sqrt(3/(4 pi)). All ten products of two of the four functions are "
              "integrated over the sphere by two rules, and the factors are taken from the norms.",
          .source = sources::lagarde_2011_buffer},
    Claim{
        .id = "sh-buffer-memory",
        .statement = "4 coefficients for each of 3 channels as 16-bit floats take 21 MB at 1280 x 720",
        .printed = {{"MB", "21"}},
        .inputs =
            {{"channels", "3"}, {"coefficients", "4"}, {"bits", "16"}, {"width", "1280"}, {"height", "720"}},
        .derivation =
            "Bytes a pixel times pixels, a whole number. A megabyte of the SI is 10^6 bytes; memory is "
            "often counted in 2^20 bytes (MiB of IEC 80000-13). An exact count has no last digit to round, "
            "so being off by one is not read as rounding.",
        .source = sources::lagarde_2011_buffer},
    Claim{.id = "sh-linear-loss",
          .statement =
              "lighting by 4 coefficients of spherical harmonics loses a little intensity, and 9 are closer "
              "to the original",
          .inputs = {{"coefficients", "4"},
                     {"more coefficients", "9"},
                     {"a little", "0.2"},
                     {"tolerance", "1e-12"}},
          .derivation =
              "A light lights a diffuse surface by max(cos(theta), 0); n^2 coefficients keep its bands 0 .. "
              "n - 1. The moments, integrals of c P_l(c) over [0, 1], are 1/2, 1/3, 1/8: the bands hold 3/8, "
              "1/2 and 15/128 of the energy, the squared norm 2 pi/3, and add 1/4, 1/2 and 5/16 to the value "
              "that faces the light. We read \"a little\" as: at most a fifth of the energy. The mean over "
              "all directions is band 0 alone and is kept.",
          .source = sources::lagarde_2011_buffer},
};

}  // namespace shadefit
