#pragma once

#include "approx/scalar.hpp"

/// Phase functions of volumes: Henyey-Greenstein. c = cos of the angle between the directions of the light
/// before and after it is scattered, g in (-1, 1) the mean of c. Per steradian.
namespace shadefit {

/// (1 - g^2)/(4 pi (1 + g^2 - 2 g c)^1.5), as shaders write it.
/// Source: Henyey, Greenstein 1941, "Diffuse Radiation in the Galaxy".
template <class T>
T henyey_greenstein(const T& cos_theta, const T& g) {
  const T one = integer<T>(1), two = integer<T>(2);
  const T base = one + g * g - two * g * cos_theta;
  return (one - g * g) / (integer<T>(4) * pi<T>() * power(base, integer<T>(3) / two));
}

/// The same from c with the power 3/2 as a product, d^3 with d = sqrt(1 + g^2 - 2 g c): no logarithm.
template <class T>
T henyey_greenstein_by_sqrt(const T& cos_theta, const T& g) {
  const T one = integer<T>(1), two = integer<T>(2);
  const T base = one + g * g - two * g * cos_theta;
  return (one - g * g) / (integer<T>(4) * pi<T>() * (base * sqrt(base)));
}

/// The k with which `schlick_phase` approximates Henyey-Greenstein of g: a g - b g^3, printed 1.55 and 0.55.
/// Source: Pharr, Humphreys 2010, "Physically Based Rendering", 2nd edition, section 11.2.
template <class T>
T schlick_phase_parameter(const T& g, const T& a, const T& b) {
  return a * g - b * (g * g * g);
}

/// Schlick's phase function (1 - k^2)/(4 pi (1 - k c)^2), c signed as in `henyey_greenstein`: k > 0 scatters
/// forward. It integrates to 1 for every |k| < 1.
/// Source: Blasi, Le Saec, Schlick 1993, "A Rendering Algorithm for Discrete Volume Density Objects".
template <class T>
T schlick_phase(const T& cos_theta, const T& k) {
  const T one = integer<T>(1);
  const T base = one - k * cos_theta;
  return (one - k * k) / (integer<T>(4) * pi<T>() * (base * base));
}

}  // namespace shadefit
