#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>

#include "approx/cosine.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/symbolic.hpp"

/// The admissible parameters of a form on a domain: those for which its denominator is positive on all of it.
namespace shadefit {

/// A family whose form has a denominator declares it: `denominator(c, p)`, a function that is linear in c, of
/// a cosine and the parameters. A family without one admits all parameters.
template <class F>
concept HasDenominator = requires(const F& family, double c,
                                  const std::array<double, F::parameters.size()>& p) {
  family.denominator(c, p);
};

/// Whether the denominator is positive on the whole domain. It is linear in c, so its sign at both ends
/// decides. 1 + x rounds to a positive number only if it is positive, so rounding admits no wrong parameter.
template <class F, std::size_t N>
bool is_admissible(const F& family, const Domain& domain, const std::array<double, N>& p) {
  if constexpr (HasDenominator<F>) {
    return family.denominator(domain.lower, p) > 0 && family.denominator(domain.upper, p) > 0;
  } else {
    return true;
  }
}

/// A place in the domain where the denominator vanishes, for parameters that are not admissible.
template <HasDenominator F, std::size_t N>
Cosine<double> pole_in(const F& family, const Domain& domain, const std::array<double, N>& p) {
  const double left = family.denominator(domain.lower, p), right = family.denominator(domain.upper, p);
  const double share = left > 0 ? left / (left - right) : 0;
  const double c = domain.lower + share * (domain.upper - domain.lower);
  return {c, 1 - c};
}

/// The rule that admissible parameters keep: "1 + a c > 0 for c in [0, 1]".
template <HasDenominator F>
std::string rule_of_admission(const F& family, const Domain& domain) {
  const Symbolic denominator = std::apply(
      [&](const auto&... name) {
        return family.denominator(Symbolic::variable("c"), std::array{Symbolic::variable(name)...});
      },
      F::parameters);
  return to_text(denominator) + " > 0 for c in [" + to_text(domain.lower) + ", " + to_text(domain.upper) +
         "]";
}

}  // namespace shadefit
