#include "fit/scalars/half_result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "fit/scalars/half.hpp"

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double half_of(double x) {
  return static_cast<double>(static_cast<float>(round_to_half(x)));
}

double rounded(double x) {
  return static_cast<double>(HalfResult::rounded(x));
}

bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

// Every half, every middle between two halves, and the doubles next to both: where rounding decides.
TEST(HalfResult, IsRoundedLikeAHalfEverywhereThatItDecides) {
  const auto half_of_bits = [](std::uint16_t bits) {
    return static_cast<double>(static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(bits)));
  };
  for (std::uint16_t bits = 0; bits < 0x7c00; ++bits) {
    const double half = half_of_bits(bits);
    const double next = bits == 0x7bff ? 65536 : half_of_bits(static_cast<std::uint16_t>(bits + 1));
    for (const double x : {half, (half + next) / 2}) {
      for (const double near : {x, std::nextafter(x, 0.0), std::nextafter(x, infinity)}) {
        EXPECT_TRUE(is_same(rounded(near), half_of(near))) << near;
        EXPECT_TRUE(is_same(rounded(-near), half_of(-near))) << -near;
      }
    }
  }
  for (const double x : {65519.999, 65520.0, 1e300, 1e-300, infinity, 0x1p-25, std::nan("")}) {
    EXPECT_TRUE(is_same(rounded(x), half_of(x))) << x;
    EXPECT_TRUE(is_same(rounded(-x), half_of(-x))) << -x;
  }
}

TEST(HalfResult, OfHalvesIsTheArithmeticOfHalf) {
  for (int i = 1; i <= 400; ++i) {
    for (const double b : {0.3, 1.7, 1477.0, 60000.0}) {
      const Eigen::half x = round_to_half(i * 0.37), y = round_to_half(b);
      const auto wide = [](Eigen::half h) { return static_cast<double>(static_cast<float>(h)); };
      const HalfResult u(wide(x)), v(wide(y));
      EXPECT_EQ(static_cast<double>(u + v), wide(x + y));
      EXPECT_EQ(static_cast<double>(u - v), wide(x - y));
      EXPECT_EQ(static_cast<double>(u * v), wide(x * y));
      EXPECT_EQ(static_cast<double>(u / v), wide(x / y));
      EXPECT_EQ(static_cast<double>(log2(u)), wide(log2(x)));
      EXPECT_EQ(static_cast<double>(exp2(-u)), wide(exp2(-x)));
    }
  }
}

TEST(HalfResult, TakesAnOperandAsItIs) {
  const double cosine = 1 - 0x1p-20;  // no half: it would be 1
  EXPECT_EQ(static_cast<double>(HalfResult(cosine)), cosine);
  EXPECT_EQ(static_cast<double>(HalfResult(cosine) - HalfResult(1)), -0x1p-20) << "the result is a half";
  EXPECT_EQ(static_cast<double>(HalfResult(cosine) * HalfResult(1)), 1);
}

}  // namespace
}  // namespace shadefit
