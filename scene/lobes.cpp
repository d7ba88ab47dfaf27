#include "scene/lobes.hpp"

#include <algorithm>
#include <array>

#include "approx/gloss.hpp"

namespace shadefit::scene {
namespace {

/// Facing the surface, of diamond 0.17; nothing clear that is rendered has more.
constexpr double most_of_dielectrics = 0.2;

double largest_of(const std::array<Range, 3>& channels) {
  return std::max({channels[0].most, channels[1].most, channels[2].most});
}

std::vector<WeightedPower> each_once(std::vector<WeightedPower> lobes) {
  std::sort(lobes.begin(), lobes.end(), [](const WeightedPower& a, const WeightedPower& b) {
    return a.power != b.power ? a.power < b.power : a.factor > b.factor;
  });
  const auto is_same = [](const WeightedPower& a, const WeightedPower& b) { return a.power == b.power; };
  lobes.erase(std::unique(lobes.begin(), lobes.end(), is_same), lobes.end());
  return lobes;
}

}  // namespace

double largest_reflectance(const Material& material) {
  const double facing = largest_of(material.f0);
  return material.fresnel == FresnelTerm::none ? facing : std::max(facing, material.f90.most);
}

double largest_factor(const Material& material, double power) {
  return largest_reflectance(material) * game_normalisation(power);
}

Range powers_of(const Material& material) {
  return {material.powers.front().power, material.powers.back().power};
}

double Lobes::largest_factor() const {
  double largest = 0;
  for (const WeightedPower& lobe : powers) largest = std::max(largest, lobe.factor);
  return largest;
}

Lobes lobes_of(const std::vector<Material>& materials, const std::vector<bool>& has_lobe) {
  Lobes lobes;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!has_lobe[i]) continue;
    const Material& material = materials[i];
    for (const PowerShare& share : material.powers)
      lobes.powers.push_back({share.power, largest_factor(material, share.power)});
    const auto& f0 = material.f0;
    lobes.textures.insert(material.power_texture);
    lobes.has_schlick = lobes.has_schlick || material.fresnel == FresnelTerm::schlick;
    // a range of its own for each channel is one of colours
    lobes.is_coloured = lobes.is_coloured || f0[0] != f0[1] || f0[1] != f0[2];
    lobes.has_metal =
        lobes.has_metal || (material.fresnel == FresnelTerm::schlick && largest_of(f0) > most_of_dielectrics);
  }
  lobes.powers = each_once(std::move(lobes.powers));
  return lobes;
}

}  // namespace shadefit::scene
