#include "bench/forms/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <tuple>
#include <utility>
#include <vector>

#include "approx/exp2_polynomial.hpp"
#include "approx/scalar.hpp"
#include "bench/forms/forms.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit::forms {

/// A number whose operations are those of R and whose functions are evaluated in long double and rounded
/// once.
///
/// The table of errors must not depend on the machine's library. The GNU C library uses fused instructions
/// where available, and then differs in the last bit at a few places. Its own float functions are within
/// 0.51 ulp of the truth, those of double within one; these within 0.50.
template <std::floating_point R>
struct Library {
  R value;

  friend Library operator+(const Library& a, const Library& b) { return {a.value + b.value}; }
  friend Library operator-(const Library& a, const Library& b) { return {a.value - b.value}; }
  friend Library operator-(const Library& a) { return {-a.value}; }
  friend Library operator*(const Library& a, const Library& b) { return {a.value * b.value}; }
  friend Library operator/(const Library& a, const Library& b) { return {a.value / b.value}; }
};

}  // namespace shadefit::forms

namespace shadefit {

template <std::floating_point R>
struct Scalar<forms::Library<R>> {
  using T = forms::Library<R>;
  using Wide = Scalar<long double>;

  static T exp2(const T& x) { return {static_cast<R>(Wide::exp2(x.value))}; }
  static T log2(const T& x) { return {static_cast<R>(Wide::log2(x.value))}; }
  static T power(const T& x, const T& p) { return {static_cast<R>(Wide::power(x.value, p.value))}; }
  static T sqrt(const T& x) { return {std::sqrt(x.value)}; }
  static T max(const T& a, const T& b) { return {Scalar<R>::max(a.value, b.value)}; }
  static T integer(int n) { return {Scalar<R>::integer(n)}; }
  static T from_decimal(std::string_view decimal) { return {Scalar<R>::from_decimal(decimal)}; }
  static T pi() { return {Scalar<R>::pi()}; }
  static T ln2() { return {Scalar<R>::ln2()}; }
};

}  // namespace shadefit

namespace shadefit::forms {
namespace {

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

/// What a function says of 0 .. N - 1.
template <std::size_t N, class Of>
auto each(const Of& of) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<decltype(of(std::size_t{})), N>{of(I)...};
  }
  (std::make_index_sequence<N>());
}

/// The loop over places: the same for every form and scalar. Forms of lights are summed in the order of the
/// lights.
template <std::size_t I, class S>
std::vector<RealOf<S>> values_of(const Inputs<RealOf<S>>& in, std::span<const RealOf<S>> parameters) {
  std::vector<RealOf<S>> values = in.front();  // as many as there are places
  constexpr auto& form = std::get<I>(all_forms);
  constexpr bool has_lights = form.arguments == Arguments::normal_to_lights;
  constexpr std::size_t inputs = 1 + static_cast<std::size_t>(form.arguments);
  const std::size_t lights = has_lights ? (parameters.size() - (form.parameters - 3)) / 3 : 1;
  for (std::size_t light = 0; light < lights; ++light) {
    const auto given = each<form.parameters>([&](std::size_t i) {
      // k, the directions of all lights, then the form's.
      const std::size_t skipped = !has_lights || i == 0 ? 0 : i < 4 ? 3 * light : 3 * (lights - 1);
      return S{parameters[i + skipped]};
    });
    for (std::size_t i = 0; i < values.size(); ++i) {
      const S value = form.formula(each<inputs>([&](std::size_t a) { return S{in[a][i]}; }), given);
      values[i] = number_of(light == 0 ? value : S(S{values[i]} + value));
    }
  }
  return values;
}

template <std::size_t I, int degree>
FormKernels with_polynomial() {
  FormKernels kernels{.form = std::get<I>(all_forms).id, .exp2_degree = degree};
  kernels.in_float = values_of<I, WithExp2<float, Exp2Choice<degree, float>>>;
  // Below 4 float is accurate enough, and 5 is hardly cheaper than 6.
  if constexpr (degree == 4 || degree == 6)
    kernels.in_double = values_of<I, WithExp2<double, Exp2Choice<degree, double>>>;
  return kernels;
}

template <std::size_t I>
void append(std::vector<FormKernels>& all) {
  constexpr auto& form = std::get<I>(all_forms);
  all.push_back({form.id, 0, values_of<I, float>, values_of<I, double>, values_of<I, Library<float>>,
                 values_of<I, Library<double>>, values_of<I, Eigen::half>, values_of<I, long double>,
                 values_of<I, Symbolic>});
  if constexpr (form.has_exp2) {
    [&]<std::size_t... D>(std::index_sequence<D...>) {
      (all.push_back(with_polynomial<I, least_exp2_degree + static_cast<int>(D)>()), ...);
    }
    (std::make_index_sequence<exp2_for_float.size()>());
  }
}

std::vector<FormKernels> all_kernels() {
  std::vector<FormKernels> all;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (append<I>(all), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(all_forms)>>());
  return all;
}

}  // namespace

std::span<const FormKernels> kernels_of(std::string_view form) {
  static const std::vector<FormKernels> all = all_kernels();
  const auto first = std::ranges::find(all, form, &FormKernels::form);
  const auto is_other = [&](const FormKernels& kernels) { return kernels.form != form; };
  return {first, std::find_if(first, all.end(), is_other)};
}

}  // namespace shadefit::forms
