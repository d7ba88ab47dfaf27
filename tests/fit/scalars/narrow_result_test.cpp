#include "fit/scalars/narrow_result.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fit/rounding/lattice.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Format>
double rounded(double x) {
  return static_cast<double>(NarrowResult<Format>::rounded(x));
}

double bfloat16_of_bits(std::uint16_t bits) {
  return static_cast<double>(static_cast<float>(Eigen::numext::bit_cast<Eigen::bfloat16>(bits)));
}

bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

// Every bfloat16, every middle between two, and the doubles next to both. A middle goes to the neighbour
// whose last bit is 0.
TEST(NarrowResult, OfBfloat16IsTheNearestTiesToEven) {
  for (std::uint16_t bits = 0; bits < 0x7f80; ++bits) {
    const double low = bfloat16_of_bits(bits);
    const double high = bits == 0x7f7f ? 0x1p128 : bfloat16_of_bits(static_cast<std::uint16_t>(bits + 1));
    const double beyond = bits == 0x7f7f ? infinity : high;
    const double middle = (low + high) / 2;
    for (const double sign : {1.0, -1.0}) {
      const auto is_rounded_to = [&](double x, double expected) {
        return is_same(rounded<Bfloat16Format>(sign * x), sign * expected);
      };
      EXPECT_TRUE(is_rounded_to(low, low)) << bits;
      EXPECT_TRUE(is_rounded_to(middle, bits % 2 == 0 ? low : beyond)) << bits;
      EXPECT_TRUE(is_rounded_to(std::nextafter(middle, 0.0), low)) << bits;
      EXPECT_TRUE(is_rounded_to(std::nextafter(middle, infinity), beyond)) << bits;
    }
  }
  EXPECT_TRUE(std::isnan(rounded<Bfloat16Format>(std::nan(""))));
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

// Eigen computes with bfloat16 as float and rounds that, for one operation the same.
TEST(NarrowResult, OfBfloat16IsTheArithmeticOfEigen) {
  using T = NarrowResult<Bfloat16Format>;
  for (std::uint32_t i = 0; i < 0x10000; i += 7) {
    for (std::uint32_t j = 0; j < 0x10000; j += 1009) {
      const auto a = Eigen::numext::bit_cast<Eigen::bfloat16>(static_cast<std::uint16_t>(i));
      const auto b = Eigen::numext::bit_cast<Eigen::bfloat16>(static_cast<std::uint16_t>(j));
      const T x(static_cast<double>(static_cast<float>(a))), y(static_cast<double>(static_cast<float>(b)));
      if (std::isnan(static_cast<double>(x)) || std::isnan(static_cast<double>(y))) continue;
      const auto agrees = [&](T ours, Eigen::bfloat16 theirs) {
        const auto wide = static_cast<double>(static_cast<float>(theirs));
        return static_cast<double>(ours) == wide ||
               (std::isnan(wide) && std::isnan(static_cast<double>(ours)));
      };
      ASSERT_TRUE(agrees(x + y, a + b)) << i << " " << j;
      ASSERT_TRUE(agrees(x - y, a - b)) << i << " " << j;
      ASSERT_TRUE(agrees(x * y, a * b)) << i << " " << j;
    }
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

template <class Format>
void expect_functions_correctly_rounded() {
  expect_no_near_tie<Format>("exp", [](double x) { return std::exp(x); });
  expect_no_near_tie<Format>("exp2", [](double x) { return std::exp2(x); });
  expect_no_near_tie<Format>("log", [](double x) { return std::log(x); });
  expect_no_near_tie<Format>("log2", [](double x) { return std::log2(x); });
}

TEST(NarrowResult, FunctionsAreCorrectlyRoundedForEveryHalfAndBfloat16) {
  expect_functions_correctly_rounded<HalfFormat>();
  expect_functions_correctly_rounded<Bfloat16Format>();
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
