#include "fit/formula/wide_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace shadefit {
namespace {

constexpr Operation operations[] = {Operation::add, Operation::subtract, Operation::multiply,
                                    Operation::divide, Operation::negate};
constexpr std::size_t groups = WideLoops::most_groups, packs = groups * WideLoops::group;

/// Numbers of either sign and many sizes.
std::vector<TwoLanes> any_numbers(std::mt19937_64& random) {
  const auto any = [&] {
    return std::ldexp(static_cast<double>(random() >> 11) - 0x1p52, static_cast<int>(random() % 80) - 92);
  };
  std::vector<TwoLanes> result;
  for (std::size_t i = 0; i < packs; ++i) {
    const double first = any();
    result.emplace_back(first, any());
  }
  return result;
}

double result_of(Operation op, double a, double b) {
  switch (op) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    default:
      return -a;
  }
}

bool has_same_bits(const std::vector<TwoLanes>& a, const std::vector<TwoLanes>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(TwoLanes)) == 0;
}

std::vector<TwoLanes> sums_of(const WideLoops& loops, const std::vector<std::vector<TwoLanes>>& columns,
                              const std::vector<TwoLanes>& weights) {
  std::vector<const TwoLanes*> firsts;
  for (const auto& column : columns) firsts.push_back(column.data());
  std::vector<TwoLanes> sums(firsts.size() * (firsts.size() + 1) / 2 * WideLoops::group, TwoLanes(0));
  // In two calls, the second with fewer groups.
  constexpr std::size_t first = groups - 3, skipped = first * WideLoops::group;
  loops.add_products(weights.data(), firsts, sums.data(), first);
  for (const TwoLanes*& first_pack : firsts) first_pack += skipped;
  loops.add_products(weights.data() + skipped, firsts, sums.data(), groups - first);
  return sums;
}

TEST(WideLoops, CombineAsSingleDoublesDo) {
  std::mt19937_64 random(1);
  const auto a = any_numbers(random), b = any_numbers(random);
  for (const Operation op : operations) {
    std::vector<TwoLanes> expected, result(packs, TwoLanes(0));
    for (std::size_t i = 0; i < packs; ++i)
      expected.emplace_back(result_of(op, a[i][0], b[i][0]), result_of(op, a[i][1], b[i][1]));
    loops_of_two().combine(op, a.data(), b.data(), result.data(), groups);
    EXPECT_TRUE(has_same_bits(result, expected)) << static_cast<int>(op);
  }
}

TEST(WideLoops, AddProductsOfAllPairs) {
  std::mt19937_64 random(2);
  // All remainders by the columns that are added at a time.
  for (const std::size_t count : {1U, 2U, 3U, 9U}) {
    std::vector<std::vector<TwoLanes>> columns;
    for (std::size_t i = 0; i < count; ++i) columns.push_back(any_numbers(random));
    const auto weights = any_numbers(random), sums = sums_of(loops_of_two(), columns, weights);
    const TwoLanes* parts = sums.data();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j <= i; ++j, parts += WideLoops::group) {
        long double sum = 0, expected = 0, size = 0;
        for (std::size_t p = 0; p < WideLoops::group; ++p) sum += parts[p][0] + parts[p][1];
        for (std::size_t k = 0; k < packs; ++k) {
          for (const std::size_t lane : {0U, 1U}) {
            const long double product =
                static_cast<long double>(weights[k][lane]) * columns[i][k][lane] * columns[j][k][lane];
            expected += product;
            size += std::abs(product);
          }
        }
        // Two roundings of each product and those of sums of at most 16 + 8 terms: below 26 half ulps of 1.
        EXPECT_NEAR(static_cast<double>(sum), static_cast<double>(expected),
                    static_cast<double>(size) * 26 * 0x1p-53);
      }
    }
  }
}

TEST(WideLoops, Exp2HasTheBitsOfOnePack) {
  std::mt19937_64 random(4);
  std::vector<TwoLanes> x = any_numbers(random), expected;
  const double infinity = HUGE_VAL, none = std::nan("");
  const std::vector<TwoLanes> rare{{0, -0.0},        {infinity, -infinity}, {none, 0.5},    {1023.75, 1024},
                                   {-1022, -1023.5}, {-1024, -1e300},       {1e300, 1e-300}};
  std::copy(rare.begin(), rare.end(), x.begin());
  for (const TwoLanes& pack : x) expected.push_back(Scalar<TwoLanes>::exp2(pack));
  for (const WideLoops* loops : {&loops_of_two(), loops_of_four()}) {
    if (loops == nullptr) continue;
    std::vector<TwoLanes> result(packs, TwoLanes(0));
    loops->exp2(x.data(), result.data(), groups);
    EXPECT_TRUE(has_same_bits(result, expected));
  }
}

TEST(WideLoops, HaveTheSameBitsInWiderRegisters) {
  const WideLoops* wider = loops_of_four();
  if (wider == nullptr) GTEST_SKIP() << "this machine has no registers of four doubles";
  std::mt19937_64 random(3);
  std::vector<std::vector<TwoLanes>> columns;
  for (std::size_t i = 0; i < 9; ++i) columns.push_back(any_numbers(random));
  for (const Operation op : operations) {
    std::vector<TwoLanes> one(packs, TwoLanes(0)), other = one;
    loops_of_two().combine(op, columns[0].data(), columns[1].data(), one.data(), groups);
    wider->combine(op, columns[0].data(), columns[1].data(), other.data(), groups);
    EXPECT_TRUE(has_same_bits(one, other)) << static_cast<int>(op);
  }
  const auto weights = any_numbers(random);
  EXPECT_TRUE(has_same_bits(sums_of(loops_of_two(), columns, weights), sums_of(*wider, columns, weights)));
}

}  // namespace
}  // namespace shadefit
