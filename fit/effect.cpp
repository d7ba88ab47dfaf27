#include "fit/effect.hpp"

#include "fit/decimal.hpp"

namespace shadefit {

std::string sentence(const Effect& effect) {
  if (effect.absolute.magnitude == 0) return "none";
  if (!std::isfinite(effect.absolute.magnitude)) return "the curve leaves the range of a double";
  return "moves the curve by at most " + decimal(effect.absolute.magnitude, 2) +
         " (at c = " + decimal(effect.absolute.at.cos_theta, 3) + "), " + decimal(effect.relative, 2) +
         " of its value, " + decimal(effect.half_ulps, 2) + " ulps of a half float, " +
         decimal(effect.srgb_codes, 2) + " 8-bit sRGB codes, each at its own worst c";
}

}  // namespace shadefit
