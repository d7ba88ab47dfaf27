#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "approx/exp2_polynomial.hpp"

/// The access of a kernel to its scalar: one number of an array, or a full register.
namespace shadefit::forms {

/// - `Real`: what the arrays hold; `Inner`: the scalar without a polynomial's exp2; `size`: numbers in one;
/// - `unrolled`: how many of them a kernel works on side by side, to hide the latency of each;
/// - `load`, `codes` (8-bit ones, as numbers), `store`, `of` (the same number everywhere), `first` (of them).
template <class S>
struct Lanes;

/// The lanes of one number.
template <class R>
struct OneNumber {
  using Real = R;
  using Inner = R;
  static constexpr std::size_t size = 1;
  static constexpr std::size_t unrolled = 1;
  static R load(const R* at) { return *at; }
  static R codes(const std::uint8_t* at) { return static_cast<R>(*at); }
  static void store(R value, R* at) { *at = value; }
  static R of(R value) { return value; }
  static R wrap(R value) { return value; }
  static R first(R value) { return value; }
};

template <std::floating_point R>
struct Lanes<R> : OneNumber<R> {};

template <class T, class P>
struct Lanes<WithExp2<T, P>> : Lanes<T> {
  using S = WithExp2<T, P>;
  using Real = typename Lanes<T>::Real;
  static S load(const Real* at) { return {Lanes<T>::load(at)}; }
  static S codes(const std::uint8_t* at) { return {Lanes<T>::codes(at)}; }
  static void store(const S& value, Real* at) { Lanes<T>::store(value.value, at); }
  static S of(Real value) { return {Lanes<T>::of(value)}; }
  static S wrap(const T& value) { return {value}; }
};

}  // namespace shadefit::forms
