#include "scene/materials/reflectances.hpp"

#include <algorithm>

#include "approx/material.hpp"

namespace shadefit::scene {

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
