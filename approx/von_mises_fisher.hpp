#pragma once

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"

/// The von Mises-Fisher density: a spherical Gaussian that integrates to 1 over the sphere. c = cos of the
/// angle to its axis in [-1, 1], y = 1 - c in [0, 2], k > 0 the concentration; in 1/sr.
/// Source: Fisher 1953, "Dispersion on a sphere".
namespace shadefit {

/// k/(4 pi sinh k) e^(k c), as printed. e^k overflows if k exceeds the logarithm of the largest number of T.
template <class T>
T von_mises_fisher(const T& cos_theta, const T& concentration) {
  const T hyperbolic_sine = (exp(concentration) - exp(-concentration)) / integer<T>(2);
  return concentration / (integer<T>(4) * pi<T>() * hyperbolic_sine) * exp(concentration * cos_theta);
}

/// The same for every k, from y: k/(2 pi (1 - e^(-2k))) e^(-k y). 2 sinh k = e^k (1 - e^(-2k)); moving e^k
/// into the exponential makes that at most 1.
template <class T>
T von_mises_fisher_near_peak(const T& one_minus_cos, const T& concentration) {
  const T two = integer<T>(2);
  const T share = -expm1(-(two * concentration));  // 1 - e^(-2k)
  return concentration / (two * pi<T>() * share) *
         gaussian_lobe_near_peak(one_minus_cos, concentration, integer<T>(0));
}

/// k/(2 pi) e^(-k y): the density of a sharp lobe.
template <class T>
T von_mises_fisher_sharp(const T& one_minus_cos, const T& concentration) {
  return concentration / (integer<T>(2) * pi<T>()) *
         gaussian_lobe_near_peak(one_minus_cos, concentration, integer<T>(0));
}

/// The relative error of `von_mises_fisher_sharp`, the same at every angle: (1 - e^(-2k)) - 1 = -e^(-2k).
template <class T>
T von_mises_fisher_sharp_error(const T& concentration) {
  return -exp(-(integer<T>(2) * concentration));
}

}  // namespace shadefit
