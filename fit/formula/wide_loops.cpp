#include "fit/formula/wide_loops.hpp"

#include <array>
#include <cstdint>
#include <cstring>

namespace shadefit {
namespace {

using OfTwo = double __attribute__((vector_size(16)));
using OfFour = double __attribute__((vector_size(32)));
using BitsOfTwo = std::uint64_t __attribute__((vector_size(16)));
using BitsOfFour = std::uint64_t __attribute__((vector_size(32)));

template <class Register>
constexpr std::size_t packs_in = sizeof(Register) / sizeof(TwoLanes);

// Arrays of TwoLanes are aligned for two doubles alone: a copy is a move that needs no more.
template <class Register>
[[gnu::always_inline]] inline void load(const TwoLanes* from, Register& to) {
  std::memcpy(&to, from, sizeof to);
}
template <class Register>
[[gnu::always_inline]] inline void store(const Register& from, TwoLanes* to) {
  std::memcpy(static_cast<void*>(to), &from, sizeof from);
}

// A function for one kind of machine inlines all of its parts: they are compiled for that machine with it.

template <class Register, class Combine>
[[gnu::always_inline]] inline void each(const TwoLanes* a, const TwoLanes* b, TwoLanes* result,
                                        std::size_t groups, const Combine& combine) {
  for (std::size_t k = 0; k < groups * WideLoops::group; k += WideLoops::group) {
    for (std::size_t p = k; p < k + WideLoops::group; p += packs_in<Register>) {
      Register x, y, r;
      load(a + p, x);
      load(b + p, y);
      combine(x, y, r);
      store(r, result + p);
    }
  }
}

template <class Register>
[[gnu::always_inline]] inline void combine(Operation op, const TwoLanes* a, const TwoLanes* b,
                                           TwoLanes* result, std::size_t groups) {
  // Results by reference: a call with wider registers than those of every machine would have no convention.
  switch (op) {
    case Operation::add:
      return each<Register>(a, b, result, groups, [](const auto& x, const auto& y, auto& r) { r = x + y; });
    case Operation::subtract:
      return each<Register>(a, b, result, groups, [](const auto& x, const auto& y, auto& r) { r = x - y; });
    case Operation::multiply:
      return each<Register>(a, b, result, groups, [](const auto& x, const auto& y, auto& r) { r = x * y; });
    case Operation::divide:
      return each<Register>(a, b, result, groups, [](const auto& x, const auto& y, auto& r) { r = x / y; });
    default:
      return each<Register>(a, a, result, groups, [](const auto& x, const auto&, auto& r) { r = -x; });
  }
}

/// The steps of `Scalar<TwoLanes>::exp2`.
template <class Register, class Bits>
[[gnu::always_inline]] inline void exp2(const TwoLanes* x, TwoLanes* result, std::size_t groups) {
  using Range = ExponentLimits<double>;
  each<Register>(
      x, x, result, groups,
      [](const Register& at, const Register&, Register& r) __attribute__((always_inline)) {
        constexpr auto& c = detail::reciprocal_factorials;
        const Register least = Register{} + Range::least, largest = Register{} + Range::largest;
        const Register above = at < least ? least : at;
        const Register within = largest < above ? largest : above;
        const Register shifted = within + Range::rounder;
        const Register rest = (within - (shifted - Range::rounder)) * ln2<double>(), square = rest * rest;
        Register even = Register{} + c[10], odd = Register{} + c[11];
        for (std::size_t i = 10; i > 0; i -= 2) {
          even = even * square + c[i - 2];
          odd = odd * square + c[i - 1];
        }
        const Register power = 1.0 + (rest + square * (even + rest * odd));
        const Bits exponent = __builtin_bit_cast(Bits, shifted) << Range::mantissa_bits;
        r = __builtin_bit_cast(Register, __builtin_bit_cast(Bits, power) + exponent);
      });
}

/// The sums of N columns beside one that is weighted. Their parts do not wait for each other.
template <std::size_t N, class Register>
[[gnu::always_inline]] inline void add_some(const TwoLanes* weighted, const TwoLanes* const* columns,
                                            TwoLanes* sums, std::size_t groups) {
  constexpr std::size_t size = packs_in<Register>, parts = WideLoops::group / size;
  std::array<std::array<Register, parts>, N> here{};
  for (std::size_t k = 0; k < groups * WideLoops::group; k += WideLoops::group) {
    for (std::size_t p = 0; p < parts; ++p) {
      Register x, y;
      load(weighted + k + p * size, x);
      for (std::size_t i = 0; i < N; ++i) {
        load(columns[i] + k + p * size, y);
        here[i][p] += x * y;
      }
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t p = 0; p < parts; ++p) {
      TwoLanes* const sum = sums + i * WideLoops::group + p * size;
      Register whole;
      load(sum, whole);
      whole += here[i][p];
      store(whole, sum);
    }
  }
}

template <class Register>
[[gnu::always_inline]] inline void add_products(const TwoLanes* weights,
                                                std::span<const TwoLanes* const> columns, TwoLanes* sums,
                                                std::size_t groups) {
  std::array<TwoLanes, WideLoops::most_groups * WideLoops::group> weighted;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    combine<Register>(Operation::multiply, weights, columns[i], weighted.data(), groups);
    // Three columns at a time: their sums and a product fill the registers.
    std::size_t left = i + 1;
    const TwoLanes* const* column = columns.data();
    for (; left >= 3; left -= 3, column += 3, sums += 3 * WideLoops::group)
      add_some<3, Register>(weighted.data(), column, sums, groups);
    if (left == 2) add_some<2, Register>(weighted.data(), column, sums, groups);
    if (left == 1) add_some<1, Register>(weighted.data(), column, sums, groups);
    sums += left * WideLoops::group;
  }
}

constexpr WideLoops of_two{combine<OfTwo>, exp2<OfTwo, BitsOfTwo>, add_products<OfTwo>};

#ifdef __x86_64__
[[gnu::target("avx2")]] void combine_of_four(Operation op, const TwoLanes* a, const TwoLanes* b,
                                             TwoLanes* result, std::size_t groups) {
  combine<OfFour>(op, a, b, result, groups);
}
[[gnu::target("avx2")]] void exp2_of_four(const TwoLanes* x, TwoLanes* result, std::size_t groups) {
  exp2<OfFour, BitsOfFour>(x, result, groups);
}
[[gnu::target("avx2")]] void add_products_of_four(const TwoLanes* weights,
                                                  std::span<const TwoLanes* const> columns, TwoLanes* sums,
                                                  std::size_t groups) {
  add_products<OfFour>(weights, columns, sums, groups);
}
constexpr WideLoops of_four{combine_of_four, exp2_of_four, add_products_of_four};
#endif

}  // namespace

const WideLoops& loops_of_two() {
  return of_two;
}

#ifdef __x86_64__
const WideLoops* loops_of_four() {
  return __builtin_cpu_supports("avx2") != 0 ? &of_four : nullptr;
}
#else
const WideLoops* loops_of_four() {
  return nullptr;
}
#endif

}  // namespace shadefit
