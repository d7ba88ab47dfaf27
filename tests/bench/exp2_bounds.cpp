#include "tests/bench/exp2_bounds.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "approx/scalar.hpp"
#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/jet.hpp"
#include "tests/bench/enclosure.hpp"
#include "tests/bench/running_error.hpp"

namespace shadefit::testing {
namespace {

/// The terms of the tail that are summed. |x| <= 0.35, so each is at most a tenth of the one before.
constexpr int tail_terms = 14;

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

template <std::size_t N>
using Coefficients = std::array<Interval, N>;

/// The coefficients read in a scalar: as printed in intervals, rounded in float and double.
template <std::size_t N, class T>
Coefficients<N> read_in(const Exp2Coefficients& polynomial) {
  Coefficients<N> c;
  for (std::size_t i = 0; i < N; ++i) c[i] = Interval(constant<T>(polynomial.printed[i]));
  return c;
}

/// The factor for the part of the series that `exp2_tail` leaves out, for |x| <= 0.35 and m >= 16: 1 + x/m +
/// x^2/(m (m+1)) + .. is within 0.03 of 1, and its slope by x below 1/m (1 + 2 |x|/m + ..) < 0.1.
Interval rest_of_tail(const Interval&) {
  return span_of(0.97, 1.03);
}
ceres::Jet<Interval, 1> rest_of_tail(const ceres::Jet<Interval, 1>& r) {
  ceres::Jet<Interval, 1> rest(span_of(0.97, 1.03));
  rest.v[0] = span_of(-0.1, 0.1) * r.v[0];
  return rest;
}

/// r in [-1/2, 1/2] for a cosine in [0, 1], from the side on which it is exact.
template <class T>
T rest_of(const Cosine<T>& c) {
  return (c.cos_theta - c.one_minus_cos) / integer<T>(2);
}

/// max |p(r)/2^r - 1| for given coefficients.
template <std::size_t N>
Enclosure largest_error(const Coefficients<N>& coefficients) {
  constexpr int degree = N;
  Coefficients<N> deviations;
  for (std::size_t i = 0; i < N; ++i)
    deviations[i] = coefficients[i] - exp2_taylor_coefficient<Interval>(static_cast<int>(i) + 1);
  const auto error = [&]<class T>(const Cosine<T>& c) {
    std::array<T, N> d;
    for (std::size_t i = 0; i < N; ++i) d[i] = lift<T>(deviations[i]);
    const T r = rest_of(c);
    return exp2_relative_error(r, degree, d, exp2_tail(r, degree, rest_of_tail(r)), exp2(T(-r)));
  };
  // a tenth of the last digit of a printed bound
  return enclose_largest(error, Domain{}, 1e-5);
}

template <std::size_t N, class Format>
Exp2Bounds bounds_of(std::string_view format, const Exp2Coefficients& polynomial, const Rounding& rounding) {
  const Coefficients<N> rounded = read_in<N, Format>(polynomial);
  const Enclosure first = largest_error(read_in<N, Interval>(polynomial)), second = largest_error(rounded);
  const auto evaluated = [&](const Cosine<Interval>& c) {
    std::array<RunningError, N> operands;
    for (std::size_t i = 0; i < N; ++i) operands[i] = {rounded[i], 0, &rounding};
    const RunningError sum = exp2_near_zero(RunningError{rest_of(c), 0, &rounding}, operands);
    return largest_magnitude_in(Interval(sum.error) / Interval(smallest_magnitude_in(sum.value)));
  };
  return {.format = format,
          .polynomial = &polynomial,
          .lower = std::max(first.lower, second.lower),
          .upper = std::max(first.upper, second.upper),
          .rounding = bound_of_rounding(evaluated, Domain{})};
}

template <class Format, std::size_t Count>
void append(std::vector<Exp2Bounds>& all, std::string_view format,
            const std::array<Exp2Coefficients, Count>& polynomials, const Rounding& rounding) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (all.push_back(bounds_of<I + least_exp2_degree, Format>(format, polynomials[I], rounding)), ...);
  }
  (std::make_index_sequence<Count>());
}

}  // namespace

std::vector<Exp2Bounds> exp2_bounds() {
  std::vector<Exp2Bounds> all;
  append<float>(all, "float", exp2_for_float, float_rounding);
  append<double>(all, "double", exp2_for_double, double_rounding);
  return all;
}

}  // namespace shadefit::testing
