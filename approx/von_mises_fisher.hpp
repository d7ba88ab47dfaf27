#pragma once

#include <array>

#include "approx/lobe.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// The von Mises-Fisher density: a spherical Gaussian that integrates to 1 over the sphere. c = cos of the
/// angle to its axis in [-1, 1], y = 1 - c in [0, 2], k > 0 the concentration; in 1/sr.
/// Source: Fisher 1953, "Dispersion on a sphere".
namespace shadefit {

/// k/(4 pi sinh k) e^(k c), as it is printed. e^k leaves the range of the scalar T where k exceeds the
/// logarithm of its largest number.
template <class T>
T von_mises_fisher(const T& cos_theta, const T& concentration) {
  const T sinh = (exp(concentration) - exp(-concentration)) / integer<T>(2);
  return concentration / (integer<T>(4) * pi<T>() * sinh) * exp(concentration * cos_theta);
}

/// The same for every k, from y: k/(2 pi (1 - e^(-2k))) e^(-k y). 2 sinh k = e^k (1 - e^(-2k)), and the e^k
/// goes into the exponential, which is then at most 1.
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

/// The rows of the ledger on this topic.
inline constexpr std::array von_mises_fisher_claims{
    Claim{.id = "vmf-normalisation",
          .statement = "k/(4 pi sinh k) e^(k c) integrates to 1 over the sphere",
          .printed = {{"", "1"}},
          .inputs = {{"exponents", "0.001,0.01,0.1,1,2,10,100,1000,10000,100000"}},
          .derivation =
              "2 pi times the integral of e^(k c) over c in [-1, 1] is 4 pi sinh(k)/k. It is integrated as "
              "k/(2 pi (1 - e^(-2k))) e^(-k y), which is the same and overflows nowhere, over t = k y up to "
              "48: what lies beyond is less than e^(-48).",
          .figure = {},
          .source = sources::lagarde_2012},
    Claim{
        .id = "vmf-large-k",
        .statement = "for k > 2 the density is about k/(2 pi) e^(-k(1-c))",
        .printed = {{"k", "2"}},
        .inputs = {{"about", "0.02"}, {"no longer about", "0.05"}, {"y", "0.001,1,2"}},
        .derivation =
            "sinh k = e^k (1 - e^(-2k))/2, so this over the density is 1 - e^(-2k) at every angle: it is too "
            "small by e^(-2k) of its value, most at the smallest k. About is read as within 2 %, which is so from "
            "k = ln(50)/2 on: `conditional` for a smaller k, as it then holds beyond that, and `refuted` for one "
            "at which more than 5 % are missing.",
        .figure = {},
        .source = sources::lagarde_2012},
};

}  // namespace shadefit
