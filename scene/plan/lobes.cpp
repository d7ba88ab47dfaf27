#include "scene/plan/lobes.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "approx/gloss.hpp"

namespace shadefit::scene {
namespace {

/// The next step of powers of texels. The steps are the same for all materials, so many materials share few
/// steps. Below 1/3 the steps have a constant width.
double next_power(double power) {
  constexpr double ratio = 1.03, narrowest = 0.01;
  return std::max(power * ratio, power + narrowest);
}

/// A power that is constant, or the steps of a range.
std::vector<Range> steps_of(const Range& range) {
  if (range.is_constant()) return {range};
  std::vector<Range> steps;
  for (double low = 0; low < range.most; low = next_power(low)) {
    if (next_power(low) > range.least)
      steps.push_back({std::max(low, range.least), std::min(next_power(low), range.most)});
  }
  return steps;
}

}  // namespace

double largest_reflectance(const Material& material) {
  const auto& f0 = material.f0;
  const double facing = std::max({f0[0].most, f0[1].most, f0[2].most});
  return material.fresnel == FresnelTerm::none ? facing : std::max(facing, material.f90.most);
}

double largest_factor(const Material& material, double power) {
  return largest_reflectance(material) * game_normalisation(power);
}

Range Lobes::range() const {
  Range range = all.front().power;
  for (const WeightedPower& lobe : all)
    range = {std::min(range.least, lobe.power.least), std::max(range.most, lobe.power.most)};
  return range;
}

double Lobes::largest_factor() const {
  return std::ranges::max(all, {}, &WeightedPower::factor).factor;
}

Lobes lobes_of(const std::vector<Material>& materials, const std::vector<bool>& has_lobe) {
  Lobes lobes;
  std::map<std::pair<double, double>, double> factors;  // by the largest and the least power
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!has_lobe[i]) continue;
    const Material& material = materials[i];
    for (const Range& power : steps_of(material.power)) {
      double& factor = factors[{power.most, power.least}];
      factor = std::max(factor, largest_factor(material, power.most));
    }
    const auto& f0 = material.f0;
    lobes.textures.insert(material.power_texture);
    lobes.has_schlick = lobes.has_schlick || material.fresnel == FresnelTerm::schlick;
    lobes.is_coloured = lobes.is_coloured || material.has_unread_colours || f0[0] != f0[1] || f0[1] != f0[2];
  }
  for (const auto& [power, factor] : factors) lobes.all.push_back({{power.second, power.first}, factor});
  return lobes;
}

}  // namespace shadefit::scene
