#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "approx/exponent_bits.hpp"
#include "approx/scalar.hpp"

/// exp2 by exponent bits and a polynomial: 2^x = 2^n p(r), x = n + r, n the nearest whole number. A form
/// whose own error is a hundredth has no use for an exp2 that is good to 1e-7.
namespace shadefit {

/// A polynomial p(r) = 1 + c1 r + .. + cn r^n for 2^r on [-1/2, 1/2], minimax in the relative error among
/// those that are exact at r = 0, so that a lobe's peak is 1 and whole powers are exact.
///
/// Source: fitted by this toolkit. tests/bench/exp2_polynomial_test.cpp shows that they are the best, and
/// proves their bounds.
struct Exp2Coefficients {
  int degree;
  std::array<std::string_view, 6> printed;  ///< c1 .. cn
  std::string_view bound;  ///< of |p(r)/2^r - 1|, proven: for these digits and for what they round to alike
};

/// The degrees that there are.
inline constexpr int least_exp2_degree = 2, largest_exp2_degree = 6;

/// For float: the optimum rounded to floats, which nine digits tell apart.
inline constexpr std::array exp2_for_float{
    Exp2Coefficients{.degree = 2, .printed = {"0.702941775", "0.239864022"}, .bound = "0.0019635"},
    Exp2Coefficients{
        .degree = 3, .printed = {"0.693282902", "0.242210954", "0.0550089329"}, .bound = "0.0001013"},
    Exp2Coefficients{.degree = 4,
                     .printed = {"0.693124175", "0.240240991", "0.0559064262", "0.00958285294"},
                     .bound = "2.8343e-6"},
    Exp2Coefficients{
        .degree = 5,
        .printed = {"0.693147004", "0.240222424", "0.0555073358", "0.00967151299", "0.00132647273"},
        .bound = "1.0872e-7"},
    Exp2Coefficients{.degree = 6,
                     .printed = {"0.693147182", "0.240226477", "0.0555033237", "0.00961843692",
                                 "0.00133988739", "0.000153533620"},
                     .bound = "1.6109e-8"},
};

/// For double: the optimum to fifteen digits.
inline constexpr std::array exp2_for_double{
    Exp2Coefficients{
        .degree = 2, .printed = {"0.702941793978386", "0.239864028980511"}, .bound = "0.0019635"},
    Exp2Coefficients{.degree = 3,
                     .printed = {"0.693282927096198", "0.242210959272712", "0.0550089311303497"},
                     .bound = "0.00010129"},
    Exp2Coefficients{
        .degree = 4,
        .printed = {"0.693124193417979", "0.240240986098797", "0.0559064245957012", "0.00958285309623666"},
        .bound = "2.8198e-6"},
    Exp2Coefficients{.degree = 5,
                     .printed = {"0.693146977599167", "0.240222420853771", "0.0555073374324731",
                                 "0.00967151263955565", "0.00132647271986097"},
                     .bound = "9.148e-8"},
    Exp2Coefficients{.degree = 6,
                     .printed = {"0.693147202855045", "0.240226479136320", "0.0555033247115902",
                                 "0.00961843735744847", "0.00133988744036442", "0.000153533619441048"},
                     .bound = "1.9746e-9"},
};

/// The record of a degree among those for float or for double. Throws std::logic_error where there is none.
constexpr const Exp2Coefficients& exp2_of_degree(std::span<const Exp2Coefficients> records, int degree) {
  if (degree < least_exp2_degree || degree > largest_exp2_degree)
    throw std::logic_error("no exp2 of degree " + std::to_string(degree));
  return records[static_cast<std::size_t>(degree - least_exp2_degree)];
}

/// The polynomial of a degree, for float or for double: a type, to say at compile time which is meant.
template <int Degree, std::floating_point Format>
struct Exp2Choice {
  static_assert(least_exp2_degree <= Degree && Degree <= largest_exp2_degree);
  static constexpr const Exp2Coefficients& record =
      (std::same_as<Format, float> ? exp2_for_float : exp2_for_double)[Degree - least_exp2_degree];
};

/// A decimal number as a machine number at compile time: its digits and the power of ten below them are whole
/// numbers that a double holds, and their quotient is rounded once (to a float a second time: nine digits lie
/// nowhere near a tie).
template <std::floating_point T>
consteval T machine_number(std::string_view decimal) {
  double digits = 0, scale = 1;
  bool is_fraction = false;
  for (const char digit : decimal) {
    if (digit == '.') {
      is_fraction = true;
      continue;
    }
    digits = digits * 10 + (digit - '0');
    if (is_fraction) scale *= 10;
  }
  return static_cast<T>(digits / scale);
}

/// One of the printed coefficients in the scalar T, of which one that computes in machine numbers
/// (`Scalar<T>::Real`) has it from the compiler.
template <class P, std::size_t I, class T>
T exp2_coefficient() {
  constexpr std::string_view printed = P::record.printed[I];
  if constexpr (std::same_as<T, float> || std::same_as<T, double>) {
    return machine_number<T>(printed);
  } else if constexpr (requires { typename Scalar<T>::Real; }) {
    return Scalar<T>::of(machine_number<typename Scalar<T>::Real>(printed));
  } else {
    return constant<T>(printed);
  }
}

/// c1 .. cn in the scalar T.
template <class P, class T>
auto exp2_coefficients() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<T, sizeof...(I)>{exp2_coefficient<P, I, T>()...};
  }
  (std::make_index_sequence<static_cast<std::size_t>(P::record.degree)>());
}

/// p(r) = 1 + c1 r + .. + cn r^n by Horner's rule; |r| <= 1/2.
template <class T, class Coefficients>
T exp2_near_zero(const T& r, const Coefficients& c) {
  T sum = c.back();
  for (std::size_t i = c.size() - 1; i > 0; --i) sum = sum * r + c[i - 1];
  return sum * r + integer<T>(1);
}

/// 2^x, off by no more than `P::record.bound` of it and what rounding adds, where it is neither below the
/// least normal number nor above the largest; there see `ExponentBits`. Exact at whole numbers.
template <class P, class T>
T exp2_polynomial(const T& x) {
  const auto parts = split_exponent(x);
  return times_exp2(exp2_near_zero(parts.rest, exp2_coefficients<P, T>()), parts.whole);
}

/// A scalar that is another one but for its exp2 and exp: these are by a polynomial. Any formula runs on it.
/// It has no logarithm and so no real power.
template <class T, class P>
struct WithExp2 {
  T value;

  friend WithExp2 operator+(const WithExp2& a, const WithExp2& b) { return {a.value + b.value}; }
  friend WithExp2 operator-(const WithExp2& a, const WithExp2& b) { return {a.value - b.value}; }
  friend WithExp2 operator-(const WithExp2& a) { return {-a.value}; }
  friend WithExp2 operator*(const WithExp2& a, const WithExp2& b) { return {a.value * b.value}; }
  friend WithExp2 operator/(const WithExp2& a, const WithExp2& b) { return {a.value / b.value}; }
};

/// The adapter: all but exp2 and exp is the other scalar's.
template <class T, class P>
struct Scalar<WithExp2<T, P>> {
  using W = WithExp2<T, P>;
  using Inner = Scalar<T>;

  static W exp2(const W& x) { return {exp2_polynomial<P>(x.value)}; }
  static W exp(const W& x) { return {exp2_polynomial<P>(T(x.value * (Inner::integer(1) / Inner::ln2())))}; }
  static W sqrt(const W& x) { return {Inner::sqrt(x.value)}; }
  static auto less(const W& a, const W& b) { return Inner::less(a.value, b.value); }
  template <class Condition>
  static W select(const Condition& condition, const W& a, const W& b) {
    return {Inner::select(condition, a.value, b.value)};
  }
  static W min(const W& a, const W& b) { return {Inner::min(a.value, b.value)}; }
  static W max(const W& a, const W& b) { return {Inner::max(a.value, b.value)}; }
  static W integer(int n) { return {Inner::integer(n)}; }
  static W from_decimal(std::string_view decimal) { return {Inner::from_decimal(decimal)}; }
  static W pi() { return {Inner::pi()}; }
  static W ln2() { return {Inner::ln2()}; }
};

}  // namespace shadefit
