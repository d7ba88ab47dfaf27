#pragma once

#include "approx/kernels.hpp"
#include "approx/von_mises_fisher.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of kernels and the von Mises-Fisher density.
template <class Visit>
void kernels_formulas(const Visit& visit) {
  using Lobes = Arguments;
  visit(Formula{"von_mises_fisher", [](auto c, auto k) { return von_mises_fisher(c, k); },
                Lobes{{"0.5", "2"}, {"-0.5", "8"}}, 64});
  visit(Formula{"von_mises_fisher_near_peak", [](auto y, auto k) { return von_mises_fisher_near_peak(y, k); },
                Lobes{{"0.5", "2"}, {"0.25", "8"}}, 16});
  visit(Formula{"von_mises_fisher_sharp", [](auto y, auto k) { return von_mises_fisher_sharp(y, k); },
                Lobes{{"0.5", "2"}, {"0.25", "8"}}, 16});
  visit(Formula{"von_mises_fisher_sharp_error", [](auto k) { return von_mises_fisher_sharp_error(k); },
                Lobes{{"0.5"}, {"2"}}, 16});
  visit(Formula{"line_gaussian", [](auto x, auto t) { return line_gaussian(x, t); },
                Lobes{{"0.5", "0.25"}, {"1", "0.125"}}, 16});
  visit(Formula{"poisson_of_circle", [](auto c, auto t) { return poisson_of_circle(c, t); },
                Lobes{{"0.5", "0.25"}, {"0.75", "0.5"}}, 16});
  visit(Formula{"poisson_of_sphere", [](auto c, auto t) { return poisson_of_sphere(c, t); },
                Lobes{{"0.5", "0.25"}, {"0.75", "0.5"}}, 16});
  visit(
      Formula{"poisson_sharpness", [](auto t) { return poisson_sharpness(t); }, Lobes{{"0.25"}, {"0.5"}}, 8});
  visit(Formula{"poisson_of_circle_lobe", [](auto y, auto m) { return poisson_of_circle_lobe(y, m); },
                Lobes{{"0.25", "4"}, {"1", "8"}}, 8});
  visit(Formula{"poisson_of_sphere_lobe", [](auto y, auto m) { return poisson_of_sphere_lobe(y, m); },
                Lobes{{"0.25", "4"}, {"1", "8"}}, 16});
  visit(Formula{"next_legendre", [](auto c, auto p, auto q) { return next_legendre(c, p, q, 2); },
                Lobes{{"0.5", "-0.125", "0.5"}}, 16});
  visit(Formula{"heat_weight", [](auto t) { return heat_weight(2, t); }, Lobes{{"0.25"}, {"0.5"}}, 32});
  visit(
      Formula{"heat_tail_bound", [](auto t) { return heat_tail_bound(2, t); }, Lobes{{"0.25"}, {"0.5"}}, 32});
  visit(Formula{"legendre_series",
                [](auto c, auto a, auto b) {
                  const std::array weights{a, b, a};
                  return legendre_series(c, std::span<const decltype(c)>(weights));
                },
                Lobes{{"0.5", "1", "0.5"}}, 16});
}

}  // namespace shadefit::testing
