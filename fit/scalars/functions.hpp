#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "approx/scalar.hpp"

/// The functions of the vocabulary by their names. Reader, evaluation and tape share this list. A function is
/// stored as a loop over an array, in which the compiler inlines it.
namespace shadefit {

template <class T>
struct FunctionOfOne {
  std::string_view name;
  void (*over)(const T* x, T* results, std::size_t count);

  T operator()(const T& x) const {
    T result = x;
    over(&x, &result, 1);
    return result;
  }
};

template <class T>
struct FunctionOfTwo {
  std::string_view name;
  void (*over)(const T* x, const T* y, T* results, std::size_t count);

  T operator()(const T& x, const T& y) const {
    T result = x;
    over(&x, &y, &result, 1);
    return result;
  }
};

namespace detail {

template <class T, const auto& function>
void one_over(const T* x, T* results, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) results[i] = function(x[i]);
}
template <class T, const auto& function>
void two_over(const T* x, const T* y, T* results, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) results[i] = function(x[i], y[i]);
}

}  // namespace detail

template <class T>
inline constexpr std::array functions_of_one{
    FunctionOfOne<T>{"exp", detail::one_over<T, exp>},
    FunctionOfOne<T>{"exp2", detail::one_over<T, exp2>},
    FunctionOfOne<T>{"log", detail::one_over<T, log>},
    FunctionOfOne<T>{"log2", detail::one_over<T, log2>},
    FunctionOfOne<T>{"expm1", detail::one_over<T, expm1>},
    FunctionOfOne<T>{"log1p", detail::one_over<T, log1p>},
    FunctionOfOne<T>{"log1p_remainder", detail::one_over<T, log1p_remainder>},
    FunctionOfOne<T>{"erf", detail::one_over<T, erf>},
    FunctionOfOne<T>{"erfc", detail::one_over<T, erfc>},
    FunctionOfOne<T>{"sqrt", detail::one_over<T, sqrt>},
    FunctionOfOne<T>{"sin", detail::one_over<T, sin>},
    FunctionOfOne<T>{"cos", detail::one_over<T, cos>},
    FunctionOfOne<T>{"tan", detail::one_over<T, tan>},
    FunctionOfOne<T>{"asin", detail::one_over<T, asin>},
    FunctionOfOne<T>{"acos", detail::one_over<T, acos>},
    FunctionOfOne<T>{"atan", detail::one_over<T, atan>},
    FunctionOfOne<T>{"sinh", detail::one_over<T, sinh>},
    FunctionOfOne<T>{"cosh", detail::one_over<T, cosh>},
    FunctionOfOne<T>{"tanh", detail::one_over<T, tanh>},
    FunctionOfOne<T>{"floor", detail::one_over<T, floor>},
    FunctionOfOne<T>{"abs", detail::one_over<T, abs>},
    FunctionOfOne<T>{"sign", detail::one_over<T, signum>},
};

template <class T>
inline constexpr std::array functions_of_two{
    FunctionOfTwo<T>{"min", detail::two_over<T, min>},
    FunctionOfTwo<T>{"max", detail::two_over<T, max>},
    FunctionOfTwo<T>{"atan2", detail::two_over<T, atan2>},
};

/// The function of that name, or null.
template <class List>
constexpr auto find_function(const List& functions, std::string_view name) -> const
    typename List::value_type* {
  for (const auto& function : functions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

}  // namespace shadefit
