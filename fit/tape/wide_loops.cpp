#include "fit/tape/wide_loops.hpp"

#include <array>

namespace shadefit {
namespace {

// They lie in arrays of TwoLanes.
using OfTwo = double __attribute__((vector_size(16), may_alias));
using OfFour = double __attribute__((vector_size(32), aligned(16), may_alias));

template <class Register>
constexpr std::size_t packs_in = sizeof(Register) / sizeof(TwoLanes);

template <class Register>
[[gnu::always_inline]] inline const Register& in(const TwoLanes& pack) {
  return *reinterpret_cast<const Register*>(&pack);
}
template <class Register>
[[gnu::always_inline]] inline Register& in(TwoLanes& pack) {
  return *reinterpret_cast<Register*>(&pack);
}

// A function for one kind of machine inlines all of its parts: they are compiled for that machine with it.

template <class Register, class Combine>
[[gnu::always_inline]] inline void each(const TwoLanes* a, const TwoLanes* b, TwoLanes* result,
                                        std::size_t groups, const Combine& combine) {
  for (std::size_t k = 0; k < groups * WideLoops::group; k += WideLoops::group) {
    for (std::size_t p = k; p < k + WideLoops::group; p += packs_in<Register>)
      combine(in<Register>(a[p]), in<Register>(b[p]), in<Register>(result[p]));
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

/// The sums of N columns beside one that is weighted. Their parts do not wait for each other.
template <std::size_t N, class Register>
[[gnu::always_inline]] inline void add_some(const TwoLanes* weighted, const TwoLanes* const* columns,
                                            TwoLanes* sums, std::size_t groups) {
  constexpr std::size_t size = packs_in<Register>, parts = WideLoops::group / size;
  std::array<std::array<Register, parts>, N> here{};
  for (std::size_t k = 0; k < groups * WideLoops::group; k += WideLoops::group) {
    for (std::size_t p = 0; p < parts; ++p) {
      for (std::size_t i = 0; i < N; ++i)
        here[i][p] += in<Register>(weighted[k + p * size]) * in<Register>(columns[i][k + p * size]);
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t p = 0; p < parts; ++p) in<Register>(sums[i * WideLoops::group + p * size]) += here[i][p];
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

constexpr WideLoops of_two{combine<OfTwo>, add_products<OfTwo>};

#ifdef __x86_64__
[[gnu::target("avx2")]] void combine_of_four(Operation op, const TwoLanes* a, const TwoLanes* b,
                                             TwoLanes* result, std::size_t groups) {
  combine<OfFour>(op, a, b, result, groups);
}
[[gnu::target("avx2")]] void add_products_of_four(const TwoLanes* weights,
                                                  std::span<const TwoLanes* const> columns, TwoLanes* sums,
                                                  std::size_t groups) {
  add_products<OfFour>(weights, columns, sums, groups);
}
constexpr WideLoops of_four{combine_of_four, add_products_of_four};
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
