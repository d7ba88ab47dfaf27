#include "scene/materials/conversions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "approx/gloss.hpp"
#include "approx/material.hpp"
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

ColourRange scaled_colour(const std::array<double, 3>& colour, bool is_textured) {
  ColourRange range;
  for (std::size_t i = 0; i < colour.size(); ++i) range[i] = {is_textured ? 0 : colour[i], colour[i]};
  return range;
}

Range metallic_range(const Range& dielectric, const Range& base_colour, const Range& metallic) {
  // Linear in each of the three arguments, so both ends are at corners.
  Range range{1, 0};
  for (const double f0 : {dielectric.least, dielectric.most}) {
    for (const double base : {base_colour.least, base_colour.most}) {
      for (const double m : {metallic.least, metallic.most}) {
        // At m = 1 rounding would leave a trace of the dielectric.
        const double mixed = m == 1 ? base : metallic_f0(f0, base, m);
        range = {std::min(range.least, mixed), std::max(range.most, mixed)};
      }
    }
  }
  return range;
}

Range dielectric_range(const Range& facing, const Range& specular_colour, const Range& specular) {
  // Rises with all three arguments.
  const auto reflectance = [](double f0, double colour, double factor) {
    return std::min(f0 * colour, 1.0) * factor;
  };
  return {reflectance(facing.least, specular_colour.least, specular.least),
          reflectance(facing.most, specular_colour.most, specular.most)};
}

}  // namespace shadefit::scene
