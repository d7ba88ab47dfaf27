#include "fit/proof/interval.hpp"

#include <gmp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "approx/encoding.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/decimal100.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

using testing::contains;
using testing::end;
using testing::span;

TEST(IntervalScalar, UndecidedComparisonsTakeTheHull) {
  const Interval x = span("0.25", "0.75"), half = constant<Interval>("0.5");
  EXPECT_EQ(less(x, half), Certainty::unknown);
  EXPECT_EQ(less(x, integer<Interval>(1)), Certainty::yes);
  EXPECT_EQ(less(integer<Interval>(1), x), Certainty::no);
  const Interval chosen = select(less(x, half), integer<Interval>(2), integer<Interval>(3));
  EXPECT_TRUE(contains(chosen, 2) && contains(chosen, 3));
  EXPECT_FALSE(contains(select(less(half, x - x + half), half, half), 1));
  EXPECT_TRUE(contains(srgb_encode(span("0", "1")), srgb_encode(Decimal100("0.002"))));
}

TEST(IntervalScalar, WhatIsNotANumberStaysSo) {
  const Interval root = sqrt(span("-1", "4"));
  const auto is_nan = [](const Interval& x) { return mpfi_nan_p(x.backend().data()) != 0; };
  EXPECT_TRUE(is_nan(root));
  EXPECT_EQ(less(root, integer<Interval>(1)), Certainty::unknown);
  EXPECT_TRUE(is_nan(min(root, integer<Interval>(1)))) << "the truth may be 0, or nothing";
  EXPECT_TRUE(is_nan(max(integer<Interval>(1), root)));
  EXPECT_TRUE(is_nan(select(less(root, integer<Interval>(1)), root, integer<Interval>(1))));
  EXPECT_TRUE(is_nan(log1p_remainder(span("-2", "0"))));
  EXPECT_TRUE(is_nan(power(span("-1e-60", "0.4"), constant<Interval>("2.5"))));
}

TEST(IntervalScalar, PowersReachZero) {
  const Interval wide = power(span("0", "0.4"), constant<Interval>("2.5"));
  EXPECT_TRUE(contains(wide, 0) && contains(wide, pow(Decimal100("0.4"), Decimal100("2.5"))));
  EXPECT_FALSE(contains(wide, Decimal100("0.11")));
  const Interval square = power(span("-1", "2"), 2);
  EXPECT_EQ(end(square, false), 0) << "a square is not negative";
  EXPECT_EQ(end(square, true), 4);
  EXPECT_TRUE(contains(power(span("2", "4"), -2), Decimal100("0.0625")));
}

TEST(IntervalScalar, MinMaxAndClamp) {
  const Interval a = span("-1", "2"), b = span("0", "1");
  EXPECT_EQ(end(min(a, b), false), -1);
  EXPECT_EQ(end(min(a, b), true), 1);
  EXPECT_EQ(end(max(a, b), false), 0);
  EXPECT_EQ(end(max(a, b), true), 2);
  EXPECT_EQ(end(positive_part(a), false), 0);
  const Interval remainder = log1p_remainder(span("-0.5", "0.5"));
  EXPECT_TRUE(contains(remainder, 0)) << "its maximum lies inside";
  EXPECT_TRUE(contains(remainder, log(Decimal100("0.5")) + Decimal100("0.5")));
}

TEST(IntervalScalar, EnclosesDecimalTexts) {
  const auto x = constant<Interval>("0.775");
  EXPECT_LT(end(x, false), end(x, true)) << "0.775 is no binary number";
  EXPECT_TRUE(contains(x, Decimal100("0.775")));
  EXPECT_THROW(constant<Interval>("0.7x"), std::invalid_argument);
}

/// Blocks of GMP and MPFR that are allocated and not freed.
std::atomic<int> blocks = 0;

TEST(IntervalScalar, AThreadFreesTheConstantsThatItComputed) {
  mp_set_memory_functions(
      [](std::size_t size) { return ++blocks, std::malloc(size); },
      [](void* block, std::size_t, std::size_t size) { return std::realloc(block, size); },
      [](void* block, std::size_t) { --blocks, std::free(block); });
  int inside = 0;
  std::thread([&] {
    static_cast<void>(cos(log(span("2", "3"))));
    inside = blocks;
  }).join();
  mp_set_memory_functions(nullptr, nullptr, nullptr);
  EXPECT_GT(inside, 0) << "MPFR keeps pi and log 2";
  EXPECT_EQ(blocks, 0);
}

}  // namespace
}  // namespace shadefit
