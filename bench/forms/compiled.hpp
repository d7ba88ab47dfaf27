#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bench/forms/loops.hpp"

/// The table of the kernels of one unit. It is a compile-time constant.
namespace shadefit::forms {

/// The degrees of exp2 with a double kernel: below 4 float is accurate enough, and 5 is hardly cheaper than
/// 6.
constexpr bool has_double_kernel(int degree) {
  return degree == 0 || degree == 4 || degree == 6;
}

/// A form with the library's functions (degree 0) or a polynomial of that degree.
template <class Form, class Floats, class Doubles, int degree>
consteval CompiledForm compiled() {
  CompiledForm result{.form = Form::id, .exp2_degree = degree};
  if constexpr (degree == 0) {
    result.in_float = kernel_of<Form, Floats>;
    result.in_double = kernel_of<Form, Doubles>;
  } else {
    result.in_float = kernel_of<Form, WithExp2<Floats, Exp2Choice<degree, float>>>;
    if constexpr (has_double_kernel(degree))
      result.in_double = kernel_of<Form, WithExp2<Doubles, Exp2Choice<degree, double>>>;
  }
  return result;
}

template <class Form>
inline constexpr std::size_t versions_of =
    Form::function == Function::exp2 ? 2 + largest_exp2_degree - least_exp2_degree : 1;

template <class Form, class Floats, class Doubles>
consteval std::array<CompiledForm, versions_of<Form>> versions() {
  if constexpr (Form::function == Function::exp2) {
    return {compiled<Form, Floats, Doubles, 0>(), compiled<Form, Floats, Doubles, 2>(),
            compiled<Form, Floats, Doubles, 3>(), compiled<Form, Floats, Doubles, 4>(),
            compiled<Form, Floats, Doubles, 5>(), compiled<Form, Floats, Doubles, 6>()};
  } else {
    return {compiled<Form, Floats, Doubles, 0>()};
  }
}

/// Every form for a register of floats and one of doubles.
template <class Floats, class Doubles, class... Forms>
consteval auto table_of(FormList<Forms...>) {
  std::array<CompiledForm, (versions_of<Forms> + ...)> table;
  std::size_t next = 0;
  const auto append = [&](const auto& all) {
    for (const CompiledForm& one : all) table[next++] = one;
  };
  (append(versions<Forms, Floats, Doubles>()), ...);
  return table;
}

/// The same, as a constant.
template <class Floats, class Doubles>
inline constexpr auto table = table_of<Floats, Doubles>(AllForms());

/// The tables of the units, each in one of its own.
struct Tables {
  static const std::span<const CompiledForm> scalar, sse2, avx2, avx512;
};

}  // namespace shadefit::forms
