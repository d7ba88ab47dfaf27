#include "scene/plan/choose_exp2.hpp"

#include <cmath>

#include "approx/exp2_polynomial.hpp"

namespace shadefit::scene {

/// exp2 by a polynomial has an error factor of 1 + bound, which changes no value by more than the bound.
ChosenExp2 choose_exp2(double allowed, ShownScale scale) {
  constexpr double upwards = 1 + 0x1p-40;  // safety factor, larger than the rounding of these doubles
  ChosenExp2 chosen{};
  for (const Exp2Coefficients& record : exp2_for_float) {
    const auto bound = constant<double>(record.bound);
    chosen = {record.degree, apart_by_ratio(scale, 1, std::log1p(-bound) * upwards)};
    if (chosen.error <= allowed) break;
  }
  return chosen;
}

}  // namespace shadefit::scene
