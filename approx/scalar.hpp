#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

/// The vocabulary in which every formula of shadefit is written.
///
/// A formula is a function template over its scalar and says nothing but `+ - * /` and the names of this
/// file. It then runs unchanged as float, double, long double, half precision, an automatic derivative, a
/// 50-digit number or an interval: each scalar brings one specialisation of `Scalar`, its adapter. The
/// standard types have theirs here; the others live in fit/ (jet, two lanes, multiprecision, interval, half).
/// A symbolic scalar is one more such specialisation.
///
/// The names are function objects, not functions. Finding an object turns argument-dependent lookup off, so
/// `exp(x)` in a formula never calls the `exp` of another library.
///
/// Rules for a formula: no `if`, no comparison (use `select(less(a, b), x, y)`), no floating literal (use
/// `integer<T>(5)`, `constant<T>("0.775")`, `pi<T>()`, `ln2<T>()`), every argument of the same type T, result
/// T.
namespace shadefit {

/// The customisation point: what a type must offer to be a scalar. See `Scalar<std::floating_point T>`.
template <class T>
struct Scalar;

namespace vocabulary {

struct Choose {
  /// A scalar whose conditions can be decided brings its own `choose`.
  template <class Condition, class A, class B>
  auto operator()(const Condition& condition, const A& a, const B& b) const {
    using T = decltype(a());
    if constexpr (std::same_as<Condition, bool>) {
      return condition ? a() : b();
    } else if constexpr (requires { Scalar<T>::choose(condition, a, b); }) {
      return Scalar<T>::choose(condition, a, b);
    } else {
      return T(Scalar<T>::select(condition, a(), b()));
    }
  }
};

struct Power {
  /// x^n by repeated squaring: the multiplications of a shader, in the same order in every arithmetic. A
  /// scalar that can do better (an interval's square is never negative) brings its own `integer_power`.
  template <class T>
  T operator()(const T& x, int n) const {
    if constexpr (requires { Scalar<T>::integer_power(x, n); }) {
      return Scalar<T>::integer_power(x, n);
    } else {
      if (n < 0) return Scalar<T>::integer(1) / (*this)(x, -n);
      if (n == 0) return Scalar<T>::integer(1);
      const T half = (*this)(x, n / 2);
      const T even = n < 2 ? Scalar<T>::integer(1) : half * half;
      return n % 2 == 0 ? even : n == 1 ? x : even * x;
    }
  }

  /// x^p for a real exponent; x >= 0, and 0^p = 0 for p > 0.
  template <class T>
  requires(!std::same_as<T, int>) T operator()(const T& x, const T& p) const {
    return Scalar<T>::power(x, p);
  }
};

}  // namespace vocabulary

inline constexpr auto exp = []<class T>(const T& x) -> T { return Scalar<T>::exp(x); };
inline constexpr auto exp2 = []<class T>(const T& x) -> T { return Scalar<T>::exp2(x); };
inline constexpr auto log = []<class T>(const T& x) -> T { return Scalar<T>::log(x); };
inline constexpr auto log2 = []<class T>(const T& x) -> T { return Scalar<T>::log2(x); };
inline constexpr auto expm1 = []<class T>(const T& x) -> T { return Scalar<T>::expm1(x); };
inline constexpr auto log1p = []<class T>(const T& x) -> T { return Scalar<T>::log1p(x); };
/// log1p(x) - x without its cancellation for small x; x > -1 (x = -1 gives -infinity).
inline constexpr auto log1p_remainder = []<class T>(const T& x) -> T {
  return Scalar<T>::log1p_remainder(x);
};
/// The complementary error function 2/sqrt(pi) * integral of exp(-t^2) from x to infinity.
inline constexpr auto erfc = []<class T>(const T& x) -> T { return Scalar<T>::erfc(x); };
inline constexpr auto sqrt = []<class T>(const T& x) -> T { return Scalar<T>::sqrt(x); };
inline constexpr auto sin = []<class T>(const T& x) -> T { return Scalar<T>::sin(x); };
inline constexpr auto cos = []<class T>(const T& x) -> T { return Scalar<T>::cos(x); };
inline constexpr auto tan = []<class T>(const T& x) -> T { return Scalar<T>::tan(x); };
inline constexpr auto asin = []<class T>(const T& x) -> T { return Scalar<T>::asin(x); };
inline constexpr auto acos = []<class T>(const T& x) -> T { return Scalar<T>::acos(x); };
inline constexpr auto atan = []<class T>(const T& x) -> T { return Scalar<T>::atan(x); };
/// The angle of the point (x, y) from the x-axis, in (-pi, pi].
inline constexpr auto atan2 = []<class T>(const T& y, const T& x) -> T { return Scalar<T>::atan2(y, x); };
inline constexpr auto sinh = []<class T>(const T& x) -> T { return Scalar<T>::sinh(x); };
inline constexpr auto cosh = []<class T>(const T& x) -> T { return Scalar<T>::cosh(x); };
inline constexpr auto tanh = []<class T>(const T& x) -> T { return Scalar<T>::tanh(x); };
/// The error function 1 - erfc(x).
inline constexpr auto erf = []<class T>(const T& x) -> T { return Scalar<T>::erf(x); };
/// The largest whole number that is not above x.
inline constexpr auto floor = []<class T>(const T& x) -> T { return Scalar<T>::floor(x); };
/// a < b as the scalar's own kind of condition, for `select` alone.
inline constexpr auto less = []<class T>(const T& a, const T& b) { return Scalar<T>::less(a, b); };
/// condition ? a : b; where an interval cannot decide, the hull of both.
inline constexpr auto select = []<class Condition, class T>(const Condition& condition, const T& a,
                                                            const T& b) -> T {
  return Scalar<T>::select(condition, a, b);
};
/// select(condition, a(), b()) for expensive branches: if the condition is decided, only one branch is
/// computed.
inline constexpr vocabulary::Choose choose{};
inline constexpr auto min = []<class T>(const T& a, const T& b) -> T { return Scalar<T>::min(a, b); };
inline constexpr auto max = []<class T>(const T& a, const T& b) -> T { return Scalar<T>::max(a, b); };
/// |x|. A scalar without its own `abs` takes max(x, -x).
inline constexpr auto abs = []<class T>(const T& x) -> T {
  if constexpr (requires { Scalar<T>::abs(x); }) {
    return Scalar<T>::abs(x);
  } else {
    return Scalar<T>::max(x, -x);
  }
};
/// -1, 0 or 1, as x is negative, zero or positive: the `sign` of shaders, whose name is taken by variables.
inline constexpr auto signum = []<class T>(const T& x) -> T {
  if constexpr (requires { Scalar<T>::sign(x); }) {
    return Scalar<T>::sign(x);
  } else {
    const T zero = Scalar<T>::integer(0), one = Scalar<T>::integer(1);
    return Scalar<T>::select(Scalar<T>::less(x, zero), Scalar<T>::integer(-1),
                             Scalar<T>::select(Scalar<T>::less(zero, x), one, zero));
  }
};
/// max(x, 0), the clamp that shaders write as saturate or max(dot, 0).
inline constexpr auto positive_part = []<class T>(const T& x) -> T {
  return Scalar<T>::max(x, Scalar<T>::integer(0));
};
/// power(x, int) or power(x, real) for x >= 0.
inline constexpr vocabulary::Power power{};

/// A whole number as the scalar T. Exact in every scalar up to 2048 (half has 11 significant bits).
template <class T>
T integer(int n) {
  return Scalar<T>::integer(n);
}

/// A published constant as the scalar T, converted from its decimal text (for an interval: enclosed).
template <class T>
T constant(std::string_view decimal) {
  return Scalar<T>::from_decimal(decimal);
}

/// A text as an argument of a template.
template <std::size_t N>
struct Literal {
  char text[N];
  consteval Literal(const char (&literal)[N]) { std::copy_n(literal, N, text); }
};

/// The same for a text that is written in a formula: a floating-point scalar converts it once.
template <class T, Literal decimal>
T constant() {
  if constexpr (std::floating_point<T>) {
    static const T value = constant<T>(decimal.text);
    return value;
  } else {
    return constant<T>(decimal.text);
  }
}

/// The circle constant, rounded (or enclosed) in T.
template <class T>
T pi() {
  return Scalar<T>::pi();
}

/// The natural logarithm of 2, rounded (or enclosed) in T.
template <class T>
T ln2() {
  return Scalar<T>::ln2();
}

namespace detail {

/// The number of terms of log1p_remainder's series that a type needs if each adds at least `bits` bits; an
/// even number.
template <std::floating_point T>
constexpr std::size_t remainder_terms(int bits) {
  return static_cast<std::size_t>(std::numeric_limits<T>::digits / bits / 2 * 2 + 2);
}

/// 1/3, 1/5, 1/7 .. for a sum with the precision of T.
template <std::floating_point T, std::floating_point Term = T>
inline constexpr auto reciprocals_of_odd = [] {
  std::array<Term, remainder_terms<T>(3)> r{};
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = Term(1) / static_cast<Term>(2 * i + 3);
  return r;
}();

/// The type in which log1p_remainder sums its series from the third term on. These terms are at most 1/180 of
/// the sum, and the sum is at most 1/7 of the result. If T is an extended double (64 bits), summing them in
/// double adds one to two roundings of T and halves the time.
template <std::floating_point T>
using RemainderTail = std::conditional_t<std::numeric_limits<T>::digits == 64, double, T>;

/// r (2 r^2 (1/3 + r^2/5 + ..) - x), see `log1p_remainder`, with the precision of R. T may hold several R;
/// `largest` is the largest r^2 among them.
template <std::floating_point R, class T, class Tail>
T remainder_by_series(const T& x, const T& r, const T& r2, R largest) {
  const int bits = largest * 65536 < 1 ? 16 : largest * 256 < 1 ? 8 : 3;
  // Even and odd terms are summed side by side: two chains of half the length.
  constexpr auto& reciprocals = reciprocals_of_odd<R, std::conditional_t<std::same_as<T, R>, Tail, R>>;
  const auto t2 = static_cast<Tail>(r2);
  const Tail t4 = t2 * t2;
  Tail even = 0, odd = 0;
  for (auto i = remainder_terms<R>(bits); i > 2; i -= 2) {
    odd = odd * t4 + reciprocals[i - 1];
    even = even * t4 + reciprocals[i - 2];
  }
  const T sum = T(1) / 3 + r2 * (T(1) / 5 + r2 * (even + t2 * odd));
  return r * (2 * r2 * sum - x);
}

}  // namespace detail

/// The adapter of float, double and long double: the C++ standard library.
template <std::floating_point T>
struct Scalar<T> {
  static T exp(T x) { return std::exp(x); }
  static T exp2(T x) { return std::exp2(x); }
  static T log(T x) { return std::log(x); }
  static T log2(T x) { return std::log2(x); }
  static T expm1(T x) { return std::expm1(x); }
  static T log1p(T x) { return std::log1p(x); }
  static T erfc(T x) { return std::erfc(x); }
  static T sqrt(T x) { return std::sqrt(x); }
  static T sin(T x) { return std::sin(x); }
  static T cos(T x) { return std::cos(x); }
  static T tan(T x) { return std::tan(x); }
  static T asin(T x) { return std::asin(x); }
  static T acos(T x) { return std::acos(x); }
  static T atan(T x) { return std::atan(x); }
  static T atan2(T y, T x) { return std::atan2(y, x); }
  static T sinh(T x) { return std::sinh(x); }
  static T cosh(T x) { return std::cosh(x); }
  static T tanh(T x) { return std::tanh(x); }
  static T erf(T x) { return std::erf(x); }
  static T floor(T x) { return std::floor(x); }
  static T abs(T x) { return std::abs(x); }
  static T power(T x, T p) { return std::pow(x, p); }
  static bool less(T a, T b) { return a < b; }
  static T select(bool condition, T a, T b) { return condition ? a : b; }
  static T min(T a, T b) { return b < a ? b : a; }
  static T max(T a, T b) { return a < b ? b : a; }
  static T integer(int n) { return static_cast<T>(n); }
  static T pi() { return std::numbers::pi_v<T>; }
  static T ln2() { return std::numbers::ln2_v<T>; }

  /// With r = x/(2+x), log(1+x) = 2 atanh(r) = 2 r (1 + r^2/3 + r^4/5 + ..) and 2 r - x = -x r, so
  ///   log1p(x) - x = r (2 r^2 (1/3 + r^2/5 + ..) - x).
  /// For |x| <= 1/2 the first term in the bracket stays below |x|/2.5: no cancellation, and r^2 <= 1/9, so
  /// that each term of the sum adds 3 bits; below |x| = 1/9 (r^2 < 1/256) it adds 8, below 1/129 (r^2 <
  /// 2^-16) 16. For |x| > 1/2, log1p(x) - x itself loses at most two bits.
  static T log1p_remainder(T x) {
    if (!(std::abs(x) <= T(1) / 2)) return std::log1p(x) - x;
    const T r = x / (2 + x);
    return detail::remainder_by_series<T, T, detail::RemainderTail<T>>(x, r, r * r, r * r);
  }

  static T from_decimal(std::string_view decimal) {
    T value{};
    const char* end = decimal.data() + decimal.size();
    const auto [stop, error] = std::from_chars(decimal.data(), end, value);
    if (error != std::errc{} || stop != end) {
      throw std::invalid_argument("not a decimal number: '" + std::string(decimal) + "'");
    }
    return value;
  }
};

}  // namespace shadefit
