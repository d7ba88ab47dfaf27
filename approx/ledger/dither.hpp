#pragma once

#include <array>

#include "approx/dither.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Dithering and marching through a volume.
namespace shadefit {

inline constexpr std::array dither_claims{
    Claim{.id = "bayer-4x4",
          .statement =
              "the 4 x 4 dither matrix, 0.22 in its second row and second column, holds each of `0/16` to "
              "`15/16` once",
          .printed = {{"x", printed_dither_entry}},
          .inputs = {{"matrix", printed_dither_pattern}},
          .derivation =
              "Every entry is compared with k/16, which is exact in binary. x has to be the value that the "
              "fifteen others leave over. Bayer's construction (each quarter is 4 times the smaller matrix "
              "plus an entry of the 2 x 2 one) computes every rank in a second way.",
          .source = sources::pestana_volumes_2014},
    Claim{.id = "march-steps",
          .statement =
              "a march along a ray in fog has less error with more steps; 10 steps with dithered starts and "
              "a blur have less error than 10 plain ones",
          .printed = {{"steps", "5 10 15 25 50 75 100"}, {"plain", "10"}, {"dithered", "10"}},
          .inputs = {{"matrix", printed_dither_pattern}, {"x", printed_dither_entry}},
          .derivation =
              "The loop tests at the left end of each of n steps whether the point is lit, and takes the "
              "mean. Nothing is absorbed, and for the sun the phase function is constant along the ray. The "
              "true value is the lit share of the ray. There is one shadow edge, uniformly distributed along "
              "the ray. The squared error is integrated exactly, piece by piece between the samples, and "
              "again by Warnock's formula. Whether the near or the far part is lit only changes the sign. "
              "The blur is the mean of the 16 pixels of a block. A full set of sixteenths gives 16 n evenly "
              "spaced samples: a march of 16 n steps.",
          .source = sources::pestana_volumes_2014},
    Claim{.id = "bilateral-epsilon",
          .statement =
              "in the bilateral upsampling, `color/(weight + 0.0001)` guards against a division by zero and "
              "does not darken by as much as one 8-bit sRGB code",
          .printed = {{"epsilon", "0.0001"}},
          .inputs = {{"taps", "4"}, {"falloff", "0.05"}, {"visible codes", "1"}, {"second reading", "0.5"}},
          .derivation =
              "The true mean is multiplied by W/(W + epsilon), W the sum of the weights max(0, 1 - 0.05 "
              "|depth difference|) of four taps: 4 on a flat surface, 0 where every tap is 20 units away. "
              "White loses one code at W/(W + epsilon) = decode(254/255) = q, that is at W = epsilon q/(1 - "
              "q); darker colours lose less.",
          .source = sources::pestana_volumes_2014},
};

}  // namespace shadefit
