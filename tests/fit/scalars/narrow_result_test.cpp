
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fit/rounding/lattice.hpp"
#include "fit/scalars/functions.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/scalars/narrow_result.hpp"

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Format>
double rounded(double x) {
  return static_cast<double>(NarrowResult<Format>::rounded(x));
}

bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

/// Eigen's number of a format with these bits.
template <class Number>
Number of_bits(std::uint32_t bits) {
  return Eigen::numext::bit_cast<Number>(static_cast<std::uint16_t>(bits));
}

template <class Number>
double wide(Number x) {
  return static_cast<double>(static_cast<float>(x));
}

// Every number of a format, every middle between two, and the doubles next to both. A middle goes to the
// neighbour whose last bit is 0.
template <class Format, class Number>
void expect_nearest_ties_to_even() {
  const auto last = static_cast<std::uint32_t>(BinaryLattice<Format>{}.last());
  for (std::uint32_t bits = 0; bits <= last; ++bits) {
    const double low = wide(of_bits<Number>(bits));
    const double high =
        bits == last ? power_of_two(Format::largest_exponent + 1) : wide(of_bits<Number>(bits + 1));
    const double beyond = bits == last ? infinity : high;
    const double middle = (low + high) / 2;
    for (const double sign : {1.0, -1.0}) {
      const auto is_rounded_to = [&](double x, double expected) {
        return is_same(rounded<Format>(sign * x), sign * expected);
      };
      EXPECT_TRUE(is_rounded_to(low, low)) << bits;
      EXPECT_TRUE(is_rounded_to(middle, bits % 2 == 0 ? low : beyond)) << bits;
      EXPECT_TRUE(is_rounded_to(std::nextafter(middle, 0.0), low)) << bits;
      EXPECT_TRUE(is_rounded_to(std::nextafter(middle, infinity), beyond)) << bits;
    }
  }
  EXPECT_TRUE(is_same(rounded<Format>(infinity), infinity));
  EXPECT_TRUE(is_same(rounded<Format>(-1e-300), -0.0));
  EXPECT_TRUE(std::isnan(rounded<Format>(std::nan(""))));
}

TEST(NarrowResult, IsTheNearestTiesToEven) {
  expect_nearest_ties_to_even<HalfFormat, Eigen::half>();
  expect_nearest_ties_to_even<Bfloat16Format, Eigen::bfloat16>();
}

TEST(NarrowResult, TakesAnOperandAsItIs) {
  const HalfResult cosine(1 - 0x1p-20);  // no half: it would be 1
  EXPECT_EQ(static_cast<double>(cosine), 1 - 0x1p-20);
  EXPECT_EQ(static_cast<double>(cosine - HalfResult(1)), -0x1p-20) << "the result is a half";
  EXPECT_EQ(static_cast<double>(cosine * HalfResult(1)), 1);
}

TEST(RoundToHalf, IsRoundedOnce) {
  for (int i = -1100; i < 1020; ++i)
    for (const double m :
         {1.0, 1 + 0x1p-11, 1 + 0x1p-11 + 0x1p-40, 1 + 0x1p-11 - 0x1p-40, 1.7182818, 2 - 0x1p-12})
      EXPECT_TRUE(is_same(wide(round_to_half(std::ldexp(m, i))), rounded<HalfFormat>(std::ldexp(m, i))))
          << m << i;
}

TEST(NarrowResult, OfFloatIsTheConversionOfTheProcessor) {
  for (int i = -1100; i < 1020; ++i) {
    for (const double m : {1.0, 1 + 0x1p-24, 1 + 0x1.8p-23, 1 + 0x1p-24 + 0x1p-50, 1.7182818, 2 - 0x1p-25}) {
      const double x = std::ldexp(m, i);
      EXPECT_TRUE(is_same(rounded<FloatFormat>(x), static_cast<double>(static_cast<float>(x)))) << x;
      EXPECT_TRUE(is_same(rounded<FloatFormat>(-x), static_cast<double>(static_cast<float>(-x)))) << -x;
    }
  }
}

// The cut number is not farther from 0, and its neighbour is.
template <class Format>
void expect_cut() {
  using T = NarrowResult<Format>;
  const BinaryLattice<Format> lattice;
  const auto cut = [](double x) { return static_cast<double>(T::cut_off(x)); };
  for (std::int64_t i = 0; i < lattice.last(); i += 5) {
    const double x = lattice.value(i), next = lattice.value(i + 1);
    for (const double part : {0.0, 1e-9, 0.5, 1 - 1e-9}) {
      const double between = x + part * (next - x);
      ASSERT_EQ(cut(between), x) << part;
      ASSERT_EQ(cut(-between), -x) << part;
    }
  }
  EXPECT_EQ(cut(2 * largest_of<Format>), largest_of<Format>);
  EXPECT_EQ(cut(-infinity), -infinity);
  EXPECT_TRUE(std::isnan(cut(NAN)));
}

TEST(NarrowResult, CutsOffTowardsZero) {
  expect_cut<HalfFormat>();
  expect_cut<Bfloat16Format>();
}

// Eigen computes with these formats as float and rounds that, for one operation the same. For functions of
// halves Eigen's scalar here rounds the double once.
template <class Format, class Number>
void expect_arithmetic_of_eigen() {
  using T = NarrowResult<Format>;
  for (std::uint32_t i = 0; i < 0x10000; i += 7) {
    for (std::uint32_t j = 0; j < 0x10000; j += 1009) {
      const Number a = of_bits<Number>(i), b = of_bits<Number>(j);
      const T x(wide(a)), y(wide(b));
      const auto agrees = [&](T ours, Number eigens) {
        const auto computed = static_cast<double>(ours);
        return computed == wide(eigens) || (std::isnan(computed) && std::isnan(wide(eigens)));
      };
      ASSERT_TRUE(agrees(x + y, a + b)) << i << " " << j;
      ASSERT_TRUE(agrees(x - y, a - b)) << i << " " << j;
      ASSERT_TRUE(agrees(x * y, a * b)) << i << " " << j;
    }
  }
}

TEST(NarrowResult, IsTheArithmeticOfEigen) {
  expect_arithmetic_of_eigen<HalfFormat, Eigen::half>();
  expect_arithmetic_of_eigen<Bfloat16Format, Eigen::bfloat16>();
  for (int i = 1; i <= 400; ++i) {
    const Eigen::half x = round_to_half(i * 0.37), y = round_to_half(1477.0);
    EXPECT_EQ(static_cast<double>(HalfResult(wide(x)) / HalfResult(wide(y))), wide(x / y));
    EXPECT_EQ(static_cast<double>(log2(HalfResult(wide(x)))), wide(log2(x)));
    EXPECT_EQ(static_cast<double>(exp2(-HalfResult(wide(x)))), wide(exp2(-x)));
  }
}

/// How far x lies from where its rounding turns, relative to x; infinite where x is a number of the format
/// or half way between two, exactly.
template <class Format>
double distance_from_a_tie(double x) {
  const int e = std::max(std::ilogb(x), Format::least_exponent);
  const double halves = std::ldexp(x, Format::digits - e);  // ties are its odd whole numbers
  const double tie = 2 * std::floor(halves / 2) + 1;
  return halves == tie ? infinity : std::abs(halves - tie) / std::abs(halves);
}

// Where no result lies within 1e-12 of a tie, that of a double, good to 1e-15, is rounded as the true one.
// The exceptions are exact: 2^n half way below the least number.
template <class Format, class Function>
void expect_no_near_tie(const char* name, const Function& function) {
  const BinaryLattice<Format> lattice;
  long tried = 0;
  double nearest = infinity;
  for (std::int64_t i = -lattice.last(); i <= lattice.last(); ++i) {
    const double y = function(lattice.value(i));
    if (!std::isfinite(y) || y == 0 || std::abs(y) > 2 * largest_of<Format> ||
        std::abs(y) < least_of<Format> / 4)
      continue;
    ++tried;
    const double distance = distance_from_a_tie<Format>(std::abs(y));
    if (std::isfinite(distance)) nearest = std::min(nearest, distance);
  }
  EXPECT_GT(nearest, 1e-12) << name << " of " << Format::name;
  EXPECT_GT(tried, 1000) << name;
}

TEST(NarrowResult, FunctionsAreCorrectlyRoundedForEveryHalfAndBfloat16) {
  for (const char* name : {"exp", "exp2", "log", "log2"}) {
    const auto& function = *find_function(functions_of_one<double>, name);
    expect_no_near_tie<HalfFormat>(name, function);
    expect_no_near_tie<Bfloat16Format>(name, function);
  }
}

// The measure of the last test sees a result near a tie.
TEST(NarrowResult, DistanceFromATie) {
  EXPECT_EQ(distance_from_a_tie<HalfFormat>(1 + 0x1p-11), infinity);
  EXPECT_NEAR(distance_from_a_tie<HalfFormat>(1 + 0x1p-11 + 0x1p-45), 0x1p-45, 0x1p-55);
  EXPECT_GT(distance_from_a_tie<HalfFormat>(1), 4e-4);
  EXPECT_EQ(distance_from_a_tie<HalfFormat>(0x1p-25), infinity);
}

// Against 50 digits, at every hundredth number.
TEST(NarrowResult, Exp2IsTheNearestToTheTrueOne) {
  const BinaryLattice<HalfFormat> lattice;
  const auto index_of_result = [&](std::int64_t i) {
    return lattice.nearest(static_cast<double>(exp2(NarrowResult<HalfFormat>(lattice.value(i)))));
  };
  for (std::int64_t i = -lattice.last(); i < 0; i += 101) {
    const Decimal50 truth = exp2(Decimal50(lattice.value(i)));
    const std::int64_t at = index_of_result(i);
    const auto off = [&](std::int64_t j) { return Decimal50(abs(Decimal50(lattice.value(j)) - truth)); };
    EXPECT_LE(off(at), off(at + 1));
    if (at > 0) {
      EXPECT_LE(off(at), off(at - 1));
    }
  }
}

template <class Format>
void expect_lattice_of_every_number() {
  const BinaryLattice<Format> lattice;
  double last = -infinity;
  for (std::int64_t i = -lattice.last(); i <= lattice.last(); ++i) {
    const double value = lattice.value(i);
    ASSERT_LT(last, value) << i;
    ASSERT_EQ(rounded<Format>(value), value);
    ASSERT_EQ(lattice.nearest(value), i);
    last = value;
  }
  EXPECT_EQ(last, largest_of<Format>);
  EXPECT_EQ(lattice.nearest(2 * last), lattice.last() + 1);
  EXPECT_EQ(lattice.nearest(-2 * last), -lattice.last() - 1);
}

TEST(Lattice, HoldsEveryHalfAndBfloat16InOrder) {
  expect_lattice_of_every_number<HalfFormat>();
  expect_lattice_of_every_number<Bfloat16Format>();
  EXPECT_EQ(BinaryLattice<HalfFormat>{}.last(), 0x7bff);
  EXPECT_EQ(BinaryLattice<Bfloat16Format>{}.last(), 0x7f7f);
  EXPECT_EQ(BinaryLattice<FloatFormat>{}.last(), 0x7f7fffff);
}

TEST(Lattice, OfDecimals) {
  const DecimalLattice lattice{3};
  EXPECT_EQ(lattice.text(lattice.nearest(-5.55473)), "-5.55");
  EXPECT_EQ(lattice.text(lattice.nearest(-5.55473) - 1), "-5.56");
  EXPECT_EQ(lattice.text(lattice.nearest(9.999)), "10.0");
  EXPECT_EQ(lattice.text(lattice.nearest(9.999) - 1), "9.99");
  EXPECT_EQ(lattice.text(lattice.nearest(0.00123456)), "0.00123");
  EXPECT_EQ(lattice.text(lattice.nearest(1.5e-7)), "1.50e-7");
  EXPECT_EQ(lattice.text(lattice.nearest(123456)), "1.23e5");
  EXPECT_EQ(lattice.text(lattice.nearest(321)), "321");
  EXPECT_EQ(lattice.text(0), "0");
  EXPECT_EQ(lattice.nearest(1e-30), 0);
  EXPECT_EQ(lattice.nearest(-1e30), -lattice.last() - 1);
  EXPECT_EQ(lattice.text(lattice.last()), "9.99e20");
  EXPECT_EQ(lattice.text(1), "1.00e-20");
  for (const int digits : {1, 2, 7, 15}) {
    const DecimalLattice any{digits};
    double before = -infinity;
    for (std::int64_t i = -40; i <= 40; ++i) {
      const std::int64_t index = any.nearest(0.0999) + i;
      EXPECT_LT(before, any.value(index));
      EXPECT_EQ(any.nearest(any.value(index)), index) << digits << " " << i;
      before = any.value(index);
    }
  }
}

}  // namespace
}  // namespace shadefit
