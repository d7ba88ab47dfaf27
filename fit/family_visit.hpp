#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "approx/cosine.hpp"
#include "fit/families/families.hpp"
#include "fit/fit.hpp"
#include "fit/scalars/jet.hpp"

/// Calls the templates of a family, from its id, a setting and parameter values.
namespace shadefit {

/// The family of a setting.
template <class F>
F make_family(const Setting& setting) {
  if constexpr (requires(F f) { f.exponent; }) {
    return F{{setting.exponent}};
  } else {
    return F{{setting.surface}};
  }
}

/// The values of a family's parameters, one for each name.
template <class F>
auto parameter_array(std::span<const double> parameters) {
  std::array<double, F::parameters.size()> p;
  std::copy_n(parameters.begin(), p.size(), p.begin());
  return p;
}

/// A function of the cosine that evaluates one of a family's error functions at fixed parameters, in any
/// scalar that the parameters can be lifted to.
template <class F, class P, std::size_t N, class Function>
auto at_parameters(const F& family, const std::array<P, N>& parameters, Function function) {
  return [=]<class T>(const Cosine<T>& c) {
    std::array<T, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = lift<T>(parameters[i]);
    return function(family, family.sample(c), p);
  };
}

/// Calls `visitor` with the std::type_identity of the family of that id. Throws std::logic_error where there
/// is none.
template <class Visitor>
auto visit_family(std::string_view id, const Visitor& visitor) {
  using Result = decltype(visitor(std::type_identity<std::tuple_element_t<0, Families>>{}));
  const auto search = [&]<class First, class... Rest>(
                          const auto& self, std::type_identity<std::tuple<First, Rest...>>) -> Result {
    if (id == First::info.id) return visitor(std::type_identity<First>{});
    if constexpr (sizeof...(Rest) > 0) {
      return self(self, std::type_identity<std::tuple<Rest...>>{});
    } else {
      throw std::logic_error("no family '" + std::string(id) + "'");
    }
  };
  return search(search, std::type_identity<Families>{});
}

}  // namespace shadefit
