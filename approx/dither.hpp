#pragma once

#include <array>
#include <string_view>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Dithering and marching through volumes.
namespace shadefit {

/// The rank of an entry in Bayer's dither matrix of `size` x `size` (a power of two), from 0 to size^2 - 1:
///   M_1 = 0, M_2n(r, c) = 4 M_n(r mod n, c mod n) + M_2(r / n, c / n), M_2 = (0 2; 3 1).
/// Source: Bayer 1973, "An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures".
constexpr int bayer_rank(int row, int column, int size) {
  if (size == 1) return 0;
  const int half = size / 2;
  const int r = row / half, c = column / half;
  return 4 * bayer_rank(row % half, column % half, half) + (r == c ? r : 2 + r);
}

/// The root mean square error of a march of n steps that asks at the start of each step whether it is lit,
/// for one shadow edge, uniform along the ray, and light of strength 1: the error is uniform in [0, 1/n), so
/// 1/(n sqrt 3).
template <class T>
T march_rms(const T& steps) {
  return integer<T>(1) / (steps * sqrt(integer<T>(3)));
}

/// The same where every step is asked at the fraction d in [0, 1) of its length: the error is uniform in
/// [-d/n, (1-d)/n), so sqrt((d^3 + (1-d)^3)/3)/n.
template <class T>
T march_rms_at_offset(const T& steps, const T& offset) {
  const T rest = integer<T>(1) - offset;
  return sqrt((power(offset, 3) + power(rest, 3)) / integer<T>(3)) / steps;
}

/// The weight of a tap of the bilateral upsampling whose depth is `gap` >= 0 from that of the pixel:
/// max(0, 1 - falloff gap). Source: Pestana 2014, "Volumetric lights".
template <class T>
T depth_weight(const T& gap, const T& falloff) {
  return positive_part(integer<T>(1) - falloff * gap);
}

/// sum/(weight + epsilon): a weighted mean that no weight at all makes 0 instead of 0/0. Source: as above.
template <class T>
T guarded_mean(const T& sum, const T& weight, const T& epsilon) {
  return sum / (weight + epsilon);
}

/// The 4 x 4 matrix of offsets as printed, rows by `/`, with `x` for the entry that its record prints.
inline constexpr std::string_view printed_dither_pattern =
    "0.0 0.5 0.125 0.625 / 0.75 x 0.875 0.375 / 0.1875 0.6875 0.0625 0.5625 / 0.9375 0.4375 0.8125 0.3125";
inline constexpr std::string_view printed_dither_entry = "0.22";

/// The rows of the ledger on this topic.
inline constexpr std::array dither_claims{
    Claim{.id = "bayer-4x4",
          .statement =
              "the 4 x 4 dither matrix, 0.22 in its second row and second column, holds each of 0/16 "
              "to 15/16 once",
          .printed = {{"x", printed_dither_entry}},
          .inputs = {{"matrix", printed_dither_pattern}},
          .derivation = "Every entry is compared with k/16, exact in binary. What the fifteen others leave "
                        "over is what x has to be; Bayer's construction (each quarter 4 times the smaller "
                        "matrix plus the 2 x 2 one) gives every rank a second time.",
          .source = sources::pestana_volumes_2014},
    Claim{.id = "march-steps",
          .statement = "marching a ray of light in fog, more steps have less error, and 10 steps started at "
                       "dithered offsets and blurred have less than 10 plain ones",
          .printed = {{"steps", "5 10 15 25 50 75 100"}, {"plain", "10"}, {"dithered", "10"}},
          .inputs = {{"matrix", printed_dither_pattern}, {"x", printed_dither_entry}},
          .derivation =
              "The loop asks at the left end of each of n steps whether the point is lit and takes "
              "the mean; nothing is absorbed, and for the sun the phase function is one number along "
              "the ray. The truth is the lit share of the ray. One shadow edge, uniform along it: the "
              "squared error is integrated piece by piece between the sample places, exactly, and "
              "again by Warnock's formula; whether the near or the far part is lit only turns the "
              "sign. Blurred: the mean of the 16 pixels of a block. A full set of sixteenths makes "
              "16 n evenly spaced places, a march of 16 n steps.",
          .source = sources::pestana_volumes_2014},
    Claim{
        .id = "bilateral-epsilon",
        .statement = "in the bilateral upsampling, color/(weight + 0.0001) guards against a division by zero "
                     "and does not darken by as much as one 8-bit sRGB code",
        .printed = {{"epsilon", "0.0001"}},
        .inputs = {{"taps", "4"}, {"falloff", "0.05"}, {"visible codes", "1"}, {"second reading", "0.5"}},
        .derivation = "The true mean is multiplied by W/(W + epsilon), W the sum of the weights max(0, 1 - "
                      "0.05 |depth difference|) of four taps: 4 on a flat surface, 0 where every tap is 20 "
                      "units away. White loses one code at W/(W + epsilon) = decode(254/255) = q, that is at "
                      "W = epsilon q/(1 - q); darker colours lose less.",
        .source = sources::pestana_volumes_2014},
};

}  // namespace shadefit
