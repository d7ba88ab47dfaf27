#pragma once

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>
#include <vector>

#include "fit/families/families.hpp"
#include "fit/scalars/multiprecision.hpp"

/// The distance of a fit from its optimum, by arithmetic, quadrature and formulas that its solver does not
/// use.
namespace shadefit {

/// The ends of panels, in y = 1 - c, on which the integrand of a family is smooth enough for 30 Gauss nodes.
/// For a lobe they double from 1/k, its scale, to 64/k, beyond which the square is below e^-128; then they
/// halve in c, because powers of c are singular at 0. Other families have quarters.
template <class F>
std::vector<Decimal50> joints(const F& family, const Domain& domain) {
  const Decimal50 top = 1 - Decimal50(domain.upper), bottom = 1 - Decimal50(domain.lower);
  std::vector<Decimal50> all{top, bottom};
  const auto add = [&](const Decimal50& y) {
    if (top < y && y < bottom) all.push_back(y);
  };
  if constexpr (requires { family.exponent; }) {
    const Decimal50 k(family.exponent);
    Decimal50 y = 1 / k;
    for (int i = 0; i <= 6 && 2 * y < 1; ++i, y *= 2) add(y);
    const bool is_cut = 2 * y < 1;
    if (is_cut) all[1] = std::min(bottom, std::max(Decimal50(top + y), y));
    for (int i = 1; i <= 64 && !is_cut; ++i) add(1 - ldexp(Decimal50(1), -i));
    std::erase_if(all, [&](const Decimal50& joint) { return joint > all[1]; });
  } else {
    for (int i = 1; i < 4; ++i) add(top + (bottom - top) * i / 4);
  }
  std::ranges::sort(all);
  return all;
}

/// The gradient of half the integral of (form - target)^2 dc over the domain, by the formulas of approx/.
/// Derivatives are central differences of 1e-15 of the parameter, which leave 30 of the 50 digits.
template <class F, std::size_t N>
std::array<Decimal50, N> gradient_in_50_digits(const F& family, const Domain& domain,
                                               const std::array<Decimal50, N>& p) {
  using Rule = boost::math::quadrature::gauss<Decimal50, 30>;
  using Parameters = std::array<Decimal50, N>;
  Decimal50 exponent = 0;
  if constexpr (requires { family.exponent; }) exponent = family.exponent;
  Parameters gradient{};
  const auto add = [&](const Decimal50& c, const Decimal50& weight) {
    const Decimal50 error = F::form_of(c, exponent, p) - F::target_of(c, exponent);
    for (std::size_t i = 0; i < N; ++i) {
      const Decimal50 step = Decimal50("1e-15") * p[i];
      Parameters above = p, below = p;
      above[i] += step;
      below[i] -= step;
      const Decimal50 slope = (F::form_of(c, exponent, above) - F::form_of(c, exponent, below)) / (2 * step);
      gradient[i] += weight * error * slope;
    }
  };
  const auto ends = joints(family, domain);
  for (std::size_t panel = 0; panel + 1 < ends.size(); ++panel) {
    const Decimal50 middle = (ends[panel] + ends[panel + 1]) / 2, half = ends[panel + 1] - middle;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const Decimal50 offset = half * Rule::abscissa()[i], weight = half * Rule::weights()[i];
      add(1 - middle - offset, weight);
      add(1 - middle + offset, weight);
    }
  }
  return gradient;
}

}  // namespace shadefit
