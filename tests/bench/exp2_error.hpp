#pragma once

#include <array>
#include <cstddef>

#include "approx/scalar.hpp"

/// The error of a polynomial for exp2 without its cancellation, for the fit and for the proof.
namespace shadefit::testing {

/// The terms of the tail that are summed. |x| <= 0.35, so each is at most a tenth of the one before.
inline constexpr int tail_terms = 14;

/// The series of 2^r = exp(x), x = r ln 2, from the power after the degree-th on:
///   x^(n+1)/(n+1)! (1 + x/(n+2) (1 + x/(n+3) ( .. rest))),
/// `rest` for the other terms, 1 + x/(n+15) + ..: nearly 1.
template <class T>
T exp2_tail(const T& r, int degree, const T& rest) {
  const T x = ln2<T>() * r;
  T sum = rest;
  for (int i = degree + tail_terms; i > degree + 1; --i) sum = integer<T>(1) + sum * x / integer<T>(i);
  for (int i = degree + 1; i > 0; --i) sum = sum * x / integer<T>(i);
  return sum;
}

/// p(r)/2^r - 1 = 2^-r (sum of d_i r^i - tail) for p(r) = 1 + c1 r + .. and d_i = c_i - (ln 2)^i/i!. Computed
/// literally, p(r)/2^r - 1 would lose nine digits at degree 6. `growth` is 2^-r.
template <class T, std::size_t N>
T exp2_relative_error(const T& r, int degree, const std::array<T, N>& d, const T& tail, const T& growth) {
  T sum = d[static_cast<std::size_t>(degree) - 1];
  for (auto i = static_cast<std::size_t>(degree) - 1; i > 0; --i) sum = sum * r + d[i - 1];
  return growth * (sum * r - tail);
}

/// (ln 2)^i/i!: the i-th coefficient of Taylor's series.
template <class T>
T exp2_taylor_coefficient(int i) {
  T term = integer<T>(1);
  for (int j = 1; j <= i; ++j) term = term * ln2<T>() / integer<T>(j);
  return term;
}

}  // namespace shadefit::testing
