#pragma once

#include "approx/scalar.hpp"

/// The von Mises-Fisher density: a spherical Gaussian that integrates to 1 over the sphere. c = cos of the
/// angle to its axis in [-1, 1], k > 0 the concentration; in 1/sr.
/// Source: Fisher 1953, "Dispersion on a sphere".
namespace shadefit {

/// k/(4 pi sinh k) e^(k c), as printed. e^k overflows if k exceeds the logarithm of the largest number of T.
template <class T>
T von_mises_fisher(const T& cos_theta, const T& concentration) {
  const T hyperbolic_sine = (exp(concentration) - exp(-concentration)) / integer<T>(2);
  return concentration / (integer<T>(4) * pi<T>() * hyperbolic_sine) * exp(concentration * cos_theta);
}

}  // namespace shadefit
