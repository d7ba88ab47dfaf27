#pragma once

#include "approx/scalar.hpp"

/// Dithering, and the error of marches through volumes.
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

/// The root mean square error of a march of n steps that samples the shadow at the start of each step. There
/// is one shadow edge, uniformly distributed along the ray, and the light has strength 1. The error is
/// uniform in [0, 1/n), so its root mean square is 1/(n sqrt 3).
template <class T>
T march_rms(const T& steps) {
  return integer<T>(1) / (steps * sqrt(integer<T>(3)));
}

/// The same for a march that samples each step at the fraction d in [0, 1) of its length: the error is
/// uniform in [-d/n, (1-d)/n), so sqrt((d^3 + (1-d)^3)/3)/n.
template <class T>
T march_rms_at_offset(const T& steps, const T& offset) {
  const T rest = integer<T>(1) - offset;
  return sqrt((power(offset, 3) + power(rest, 3)) / integer<T>(3)) / steps;
}

}  // namespace shadefit
