#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bench/forms/forms.hpp"
#include "bench/forms/kernel.hpp"
#include "bench/forms/lanes.hpp"

/// The loops over arrays: the same for every form and scalar.
namespace shadefit::forms {

/// The most lights that a kernel sums up.
inline constexpr std::size_t most_lights = 64;

/// The prepared constants of a form in the scalar S, computed once from its parameters.
template <class Form, class S>
auto prepared_in(const std::array<typename Lanes<S>::Real, Form::parameters>& parameters) {
  using Inner = typename Lanes<S>::Inner;
  std::array<Inner, Form::parameters> given;
  for (std::size_t i = 0; i < Form::parameters; ++i) given[i] = Lanes<Inner>::of(parameters[i]);
  const auto found = Form::template prepared<Inner>(given);
  std::array<S, std::tuple_size_v<decltype(found)>> result;
  for (std::size_t i = 0; i < found.size(); ++i) result[i] = Lanes<S>::wrap(found[i]);
  return result;
}

/// A form of one argument, or of two.
template <class Form, class S>
void over_elements(const Arrays<typename Lanes<S>::Real>& arrays,
                   std::span<const typename Lanes<S>::Real> parameters) {
  using L = Lanes<S>;
  using Real = typename L::Real;
  std::array<Real, Form::parameters> given;
  for (std::size_t i = 0; i < Form::parameters; ++i) given[i] = parameters.data()[i];
  const auto constants = prepared_in<Form, S>(given);
  const Real* const cosines = arrays.in.data()[0];
  const std::uint8_t* const codes = arrays.codes;
  Real* const out = arrays.out;
  const std::size_t size = arrays.size;
  for (std::size_t i = 0; i < size; i += L::size * L::unrolled) {
    S result[L::unrolled];
    for (std::size_t u = 0; u < L::unrolled; ++u) {
      const S c = L::load(cosines + i + u * L::size);
      if constexpr (Form::arguments == Arguments::cosine_and_code) {
        result[u] = Form()(c, L::codes(codes + i + u * L::size), constants);
      } else {
        result[u] = Form()(c, constants);
      }
    }
    for (std::size_t u = 0; u < L::unrolled; ++u) L::store(result[u], out + i + u * L::size);
  }
}

/// The lights' constants, one number each. The loop broadcasts them to a register.
template <class Form, class S>
class Lights {
 public:
  using Real = typename Lanes<S>::Real;
  static constexpr std::size_t per_light = 4;

  explicit Lights(std::span<const Real> parameters) {
    constexpr std::size_t of_form = Form::parameters - 4;  // what comes after k and a direction
    count_ = (parameters.size() - 1 - of_form) / 3;
    for (std::size_t light = 0; light < count_; ++light) {
      std::array<Real, Form::parameters> given;
      given[0] = parameters.data()[0];
      for (std::size_t i = 0; i < 3; ++i) given[1 + i] = parameters.data()[1 + 3 * light + i];
      for (std::size_t i = 0; i < of_form; ++i) given[4 + i] = parameters.data()[1 + 3 * count_ + i];
      using Inner = typename Lanes<S>::Inner;
      const auto constants = prepared_in<Form, Inner>(given);
      for (std::size_t i = 0; i < per_light; ++i) numbers_[light][i] = Lanes<Inner>::first(constants[i]);
    }
  }

  std::size_t count() const { return count_; }
  std::array<S, per_light> operator[](std::size_t light) const {
    const Real* const n = numbers_[light];
    return {Lanes<S>::of(n[0]), Lanes<S>::of(n[1]), Lanes<S>::of(n[2]), Lanes<S>::of(n[3])};
  }

 private:
  Real numbers_[most_lights][per_light];
  std::size_t count_;
};

/// A form of a normal, summed over at most `most_lights` lights in their order.
template <class Form, class S>
void over_lights(const Arrays<typename Lanes<S>::Real>& arrays,
                 std::span<const typename Lanes<S>::Real> parameters) {
  using L = Lanes<S>;
  using Real = typename L::Real;
  const Lights<Form, S> lights(parameters);
  const Real *const x = arrays.in.data()[0], *const y = arrays.in.data()[1], *const z = arrays.in.data()[2];
  Real* const out = arrays.out;
  const std::size_t size = arrays.size, count = lights.count();
  for (std::size_t i = 0; i < size; i += L::size * L::unrolled) {
    std::array<S, 3> normals[L::unrolled];
    S sums[L::unrolled];
    for (std::size_t u = 0; u < L::unrolled; ++u) {
      const std::size_t at = i + u * L::size;
      normals[u] = {L::load(x + at), L::load(y + at), L::load(z + at)};
      sums[u] = L::of(Real(0));
    }
    for (std::size_t light = 0; light < count; ++light) {
      const auto constants = lights[light];
      for (std::size_t u = 0; u < L::unrolled; ++u) sums[u] = sums[u] + Form()(normals[u], constants);
    }
    for (std::size_t u = 0; u < L::unrolled; ++u) L::store(sums[u], out + i + u * L::size);
  }
}

template <class Form, class S>
inline constexpr Kernel<typename Lanes<S>::Real> kernel_of = [] {
  if constexpr (Form::arguments == Arguments::normal_to_lights) {
    return &over_lights<Form, S>;
  } else {
    return &over_elements<Form, S>;
  }
}();

}  // namespace shadefit::forms
