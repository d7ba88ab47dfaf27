#include "scene/materials/powers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "approx/gloss.hpp"
#include "approx/microfacet.hpp"

namespace shadefit::scene {

double power_of_roughness(double stored, const Conventions& conventions) {
  const double roughness = std::max(stored, conventions.min_roughness);
  const double alpha = conventions.is_roughness_squared ? roughness * roughness : roughness;
  // The limit of the exponent, without a division by zero or by a subnormal number.
  if (alpha * alpha < std::numeric_limits<double>::min()) return std::numeric_limits<double>::infinity();
  return blinn_phong_exponent(alpha);
}

double power_of_gloss(double gloss, const Conventions& conventions) {
  if (conventions.is_gloss_exponential) return decode_gloss(gloss, 10.0, 1.0);
  return power_of_roughness(1 - gloss, conventions);
}

void take_powers(Material& material, const Range& stored, const std::function<double(double)>& power,
                 PowerTexture texture, std::string_view what) {
  const auto [least, most] = std::minmax({power(stored.least), power(stored.most)});
  material.power = {std::min(least, most_power), std::min(most, most_power)};
  material.power_texture = material.power.is_constant() ? PowerTexture::none : texture;
  if (most > most_power)
    material.remarks.push_back(fmt::format("{} = {:g} is taken for {:g}", what, most, most_power));
}

}  // namespace shadefit::scene
