#pragma once

#include <array>

#include "approx/scalar.hpp"

/// Highlights of fixed lights under a changing normal: the part of a light that is computed once.
namespace shadefit {

/// (A l, -A), A = k/ln 2: the constants of the spherical Gaussian exp2(A (n.l - 1)) around a light's
/// direction l.
template <class T>
std::array<T, 4> scaled_light(const std::array<T, 3>& light, const T& base_two) {
  return {base_two * light[0], base_two * light[1], base_two * light[2], -base_two};
}

/// exp2((A l, -A) . (n, 1)), with the last term innermost: three multiply-adds. It is the same sum as a
/// shader's dot product of four components.
template <class T>
T highlight_by_exp2(const std::array<T, 3>& normal, const std::array<T, 4>& scaled) {
  return exp2(scaled[0] * normal[0] + (scaled[1] * normal[1] + (scaled[2] * normal[2] + scaled[3])));
}

/// n.l, clamped from below to 0: the base of a highlight's power.
template <class T>
T lit_cosine(const std::array<T, 3>& normal, const std::array<T, 3>& light) {
  return positive_part(light[0] * normal[0] + (light[1] * normal[1] + light[2] * normal[2]));
}

}  // namespace shadefit
