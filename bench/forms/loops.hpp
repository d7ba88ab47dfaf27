#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "bench/forms/forms.hpp"
#include "bench/forms/kernels.hpp"

/// The loops over arrays: the same for every form and scalar.
namespace shadefit::forms {

/// The number that an array holds for a scalar: itself, or the one that it wraps.
template <class S>
auto number_of(const S& x) {
  if constexpr (requires { x.value; }) {
    return x.value;
  } else {
    return x;
  }
}

template <class S>
using RealOf = decltype(number_of(std::declval<S>()));

/// The prepared constants of a form, from its parameters.
template <class Form, class S>
auto prepared_in([[maybe_unused]] std::span<const RealOf<S>> parameters) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Form::template prepared<S>(std::array<S, Form::parameters>{S{parameters[I]}...});
  }
  (std::make_index_sequence<Form::parameters>());
}

/// A form of one argument, or of two.
template <class Form, class S>
void over_elements(const Arrays<RealOf<S>>& arrays, std::span<const RealOf<S>> parameters) {
  const auto constants = prepared_in<Form, S>(parameters);
  for (std::size_t i = 0; i < arrays.size; ++i) {
    const S c{arrays.in[0][i]};
    if constexpr (Form::arguments == Arguments::cosine_and_code) {
      arrays.out[i] = number_of(Form()(c, S{arrays.in[1][i]}, constants));
    } else {
      arrays.out[i] = number_of(Form()(c, constants));
    }
  }
}

/// A form of a normal, summed over the lights in their order.
template <class Form, class S>
void over_lights(const Arrays<RealOf<S>>& arrays, std::span<const RealOf<S>> parameters) {
  constexpr std::size_t of_form = Form::parameters - 4;  // what comes after k and a direction
  const std::size_t count = (parameters.size() - 1 - of_form) / 3;
  std::vector<decltype(prepared_in<Form, S>({}))> lights;
  for (std::size_t light = 0; light < count; ++light) {
    std::vector<RealOf<S>> given{parameters[0]};
    for (std::size_t i = 0; i < 3; ++i) given.push_back(parameters[1 + 3 * light + i]);
    for (std::size_t i = 0; i < of_form; ++i) given.push_back(parameters[1 + 3 * count + i]);
    lights.push_back(prepared_in<Form, S>(given));
  }
  for (std::size_t i = 0; i < arrays.size; ++i) {
    const std::array<S, 3> normal{S{arrays.in[0][i]}, S{arrays.in[1][i]}, S{arrays.in[2][i]}};
    S sum = Form()(normal, lights.front());
    for (const auto& light : std::span(lights).subspan(1)) sum = sum + Form()(normal, light);
    arrays.out[i] = number_of(sum);
  }
}

template <class Form, class S>
inline constexpr Kernel<RealOf<S>> kernel_of = [] {
  if constexpr (Form::arguments == Arguments::normal_to_lights) {
    return &over_lights<Form, S>;
  } else {
    return &over_elements<Form, S>;
  }
}();

}  // namespace shadefit::forms
