#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Spherical harmonics of low order, and what storing them costs. Real harmonics, orthonormal over the sphere
/// of 4 pi steradians; (x, y, z) is a unit direction, band l has 2 l + 1 of them.
namespace shadefit {

/// The harmonic of band 0, a constant: sqrt(1/(4 pi)).
template <class T>
T harmonic_of_band_zero() {
  return sqrt(integer<T>(1) / (integer<T>(4) * pi<T>()));
}

/// The factor of x, y or z in the three harmonics of band 1: sqrt(3/(4 pi)).
template <class T>
T harmonic_of_band_one() {
  return sqrt(integer<T>(3) / (integer<T>(4) * pi<T>()));
}

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
/// and for even l (-1)^(l/2 - 1) l! / ((l + 2)(l - 1) 2^l ((l/2)!)^2), here as a product of the ratios of
/// neighbours: the quotient of l! and 2^l ((l/2)!)^2 gains (n - 1)/n from l = n - 2 to n.
/// Source: Ramamoorthi, Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", which
/// has it times 2 pi.
template <class T>
T clamped_cosine_moment(int band) {
  if (band == 1) return integer<T>(1) / integer<T>(3);
  if (band % 2 != 0) return integer<T>(0);
  T product = -integer<T>(1);
  for (int n = 2; n <= band; n += 2) product = -product * integer<T>(n - 1) / integer<T>(n);
  return product / (integer<T>(band + 2) * integer<T>(band - 1));
}

/// The value that band l contributes to max(cos(theta), 0) at theta = 0, from the moment above:
/// (2 l + 1)/2 times it.
template <class T>
T peak_of_band(int band, const T& moment) {
  return integer<T>(2 * band + 1) / integer<T>(2) * moment;
}

/// The share of the energy of max(cos(theta), 0), its squared norm over the sphere, that band l holds:
/// 3/2 (2 l + 1) times the square of its moment. The norm is 2 pi/3; the band's coefficient is
/// 2 pi sqrt((2 l + 1)/(4 pi)) times the moment.
template <class T>
T energy_of_band(int band, const T& moment) {
  return integer<T>(3 * (2 * band + 1)) / integer<T>(2) * (moment * moment);
}

/// The rows of the ledger on this topic.
inline constexpr std::array harmonics_claims{
    Claim{.id = "sh-basis",
          .statement = "the real spherical harmonics of bands 0 and 1 are 0.282095 and 0.488603 times -y, z "
                       "and -x",
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
    Claim{
        .id = "sh-linear-loss",
        .statement = "lighting by 4 coefficients of spherical harmonics loses a little intensity, and 9 are "
                     "closer to the original",
        .inputs =
            {{"coefficients", "4"}, {"more coefficients", "9"}, {"a little", "0.2"}, {"tolerance", "1e-12"}},
        .derivation =
            "A light lights a diffuse surface by max(cos(theta), 0); n^2 coefficients keep its bands 0 .. "
            "n - 1. The moments, integrals of c P_l(c) over [0, 1], are 1/2, 1/3, 1/8: the bands hold 3/8, "
            "1/2 and 15/128 of the energy, the squared norm 2 pi/3, and add 1/4, 1/2 and 5/16 to the value "
            "that faces the light. \"A little\" is read as at most a fifth of the energy. The mean over all "
            "directions is band 0 alone and is kept.",
        .source = sources::lagarde_2011_buffer},
};

}  // namespace shadefit
