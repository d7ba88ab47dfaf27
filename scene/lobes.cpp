#include "scene/lobes.hpp"

#include <algorithm>
#include <array>
#include <tuple>

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
    return std::tuple(a.power.most, a.power.least, b.factor) <
           std::tuple(b.power.most, b.power.least, a.factor);
  });
  const auto is_same = [](const WeightedPower& a, const WeightedPower& b) { return a.power == b.power; };
  lobes.erase(std::unique(lobes.begin(), lobes.end(), is_same), lobes.end());
  return lobes;
}

/// The steps of powers between texels: equal ones for all materials, so that those of many are few. Up to 1/3
/// each is as wide as the last.
double next_power(double power) {
  constexpr double ratio = 1.03, narrowest = 0.01;
  return std::max(power * ratio, power + narrowest);
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

std::vector<WeightedPower> lobes_of(const Material& material) {
  const Range range = powers_of(material);
  if (range.is_constant()) return {{range, largest_factor(material, range.most)}};
  std::vector<WeightedPower> lobes;
  double most = 0;
  while (most < range.most) {
    const double least = most;
    most = next_power(least);
    if (most < range.least) continue;
    const Range part{std::max(least, range.least), std::min(most, range.most)};
    lobes.push_back({part, largest_factor(material, part.most)});
  }
  return lobes;
}

Range Lobes::range() const {
  Range range = all.front().power;
  for (const WeightedPower& lobe : all)
    range = {std::min(range.least, lobe.power.least), std::max(range.most, lobe.power.most)};
  return range;
}

double Lobes::largest_factor() const {
  double largest = 0;
  for (const WeightedPower& lobe : all) largest = std::max(largest, lobe.factor);
  return largest;
}

Lobes lobes_of(const std::vector<Material>& materials, const std::vector<bool>& has_lobe) {
  Lobes lobes;
  const auto count = static_cast<double>(std::count(has_lobe.begin(), has_lobe.end(), true));
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!has_lobe[i]) continue;
    const Material& material = materials[i];
    for (const WeightedPower& lobe : lobes_of(material)) lobes.all.push_back(lobe);
    for (const PowerShare& used : material.powers)
      lobes.used.push_back({used.power, largest_factor(material, used.power), used.share / count});
    const auto& f0 = material.f0;
    lobes.textures.insert(material.power_texture);
    lobes.has_schlick = lobes.has_schlick || material.fresnel == FresnelTerm::schlick;
    lobes.is_coloured = lobes.is_coloured || material.has_unread_colours || f0[0] != f0[1] || f0[1] != f0[2];
    lobes.has_metal =
        lobes.has_metal || (material.fresnel == FresnelTerm::schlick && largest_of(f0) > most_of_dielectrics);
  }
  lobes.all = each_once(std::move(lobes.all));
  return lobes;
}

}  // namespace shadefit::scene
