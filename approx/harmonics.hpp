#pragma once

#include "approx/scalar.hpp"

/// The bands of spherical harmonics in the clamped cosine max(cos(theta), 0). The harmonics are real and
/// orthonormal over the sphere of 4 pi steradians; band l has 2 l + 1 of them.
namespace shadefit {

/// The Legendre polynomial P_l(x) for x in [-1, 1], l >= 0, by Bonnet's recurrence
/// (n + 1) P_(n+1) = (2 n + 1) x P_n - n P_(n-1). P_l(1) = 1.
template <class T>
T legendre_polynomial(int band, const T& x) {
  T before = integer<T>(0), current = integer<T>(1);
  for (int n = 0; n < band; ++n) {
    const T next = (integer<T>(2 * n + 1) * x * current - integer<T>(n) * before) / integer<T>(n + 1);
    before = current;
    current = next;
  }
  return current;
}

/// The moment of the clamped cosine, the integral of x P_l(x) over [0, 1]: 1/3 for l = 1, 0 for other odd l,
/// and for even l (-1)^(l/2 - 1) l! / ((l + 2)(l - 1) 2^l ((l/2)!)^2), here as a product of ratios: from l =
/// n - 2 to l = n, the quotient of l! and 2^l ((l/2)!)^2 is multiplied by (n - 1)/n.
/// Source: Ramamoorthi, Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", which
/// states it times 2 pi.
template <class T>
T clamped_cosine_moment(int band) {
  if (band == 1) return integer<T>(1) / integer<T>(3);
  if (band % 2 != 0) return integer<T>(0);
  T product = -integer<T>(1);
  for (int n = 2; n <= band; n += 2) product = -product * integer<T>(n - 1) / integer<T>(n);
  return product / (integer<T>(band + 2) * integer<T>(band - 1));
}

/// The contribution of band l to max(cos(theta), 0) at theta = 0: (2 l + 1)/2 times the moment above.
template <class T>
T peak_of_band(int band, const T& moment) {
  return integer<T>(2 * band + 1) / integer<T>(2) * moment;
}

/// The share of band l in the energy of max(cos(theta), 0), its squared norm over the sphere: 3/2 (2 l + 1)
/// times the square of the moment. The norm is 2 pi/3; the band's coefficient is 2 pi sqrt((2 l + 1)/(4 pi))
/// times the moment.
template <class T>
T energy_of_band(int band, const T& moment) {
  return integer<T>(3 * (2 * band + 1)) / integer<T>(2) * (moment * moment);
}

}  // namespace shadefit
