#pragma once

#include "approx/scalar.hpp"

/// Transfer functions between linear light and what a display or a texture stores.
namespace shadefit {

/// The sRGB encoding of a linear value in [0, 1]: 12.92 x up to 0.0031308, then 1.055 x^(1/2.4) - 0.055.
/// Source: IEC 61966-2-1:1999, sRGB.
template <class T>
T srgb_encode(const T& linear) {
  const T one = integer<T>(1);
  const T straight = constant<T, "12.92">() * linear;
  const T curved =
      constant<T, "1.055">() * power(linear, one / constant<T, "2.4">()) - constant<T, "0.055">();
  return select(less(constant<T, "0.0031308">(), linear), curved, straight);
}

/// The linear value of an sRGB encoding in [0, 1], the inverse of `srgb_encode`: x/12.92 up to 0.04045, then
/// ((x + 0.055)/1.055)^2.4. Source: IEC 61966-2-1:1999, sRGB.
template <class T>
T srgb_decode(const T& encoded) {
  const T straight = encoded / constant<T, "12.92">();
  const T curved = power((encoded + constant<T, "0.055">()) / constant<T, "1.055">(), constant<T, "2.4">());
  return select(less(constant<T, "0.04045">(), encoded), curved, straight);
}

/// The sRGB code of a linear value on the 8-bit scale, as a real number in [0, 255]. The value is clamped to
/// [0, 1] first.
template <class T>
T srgb_code(const T& linear) {
  return integer<T>(255) * srgb_encode(min(positive_part(linear), integer<T>(1)));
}

}  // namespace shadefit
