#include "scene/plan/lobes.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "approx/gloss.hpp"

namespace shadefit::scene {
namespace {

/// A reflectance at normal incidence above all rendered transparent materials: diamond has 0.17.
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

/// The next step of powers of texels. The steps are the same for all materials, so many materials share few
/// steps. Below 1/3 the steps have a constant width.
double next_power(double power) {
  constexpr double ratio = 1.03, narrowest = 0.01;
  return std::max(power * ratio, power + narrowest);
}

/// All steps up to the largest power.
std::vector<double> steps_of_powers() {
  std::vector<double> steps{0};
  while (steps.back() <= most_power) steps.push_back(next_power(steps.back()));
  return steps;
}

/// Collects lobes. For textures, each step occurs once, with the largest reflectance of all materials that
/// use it.
class LobeCollection {
 public:
  void add(const Material& material) {
    const Range range = powers_of(material);
    if (range.is_constant()) {
      lobes_.push_back({range, largest_factor(material, range.most)});
      return;
    }
    const double reflectance = largest_reflectance(material);
    for (std::size_t i = step_of(range.least); steps_[i] < range.most; ++i) {
      const Range whole{steps_[i], steps_[i + 1]};
      const Range part{std::max(whole.least, range.least), std::min(whole.most, range.most)};
      if (part == whole) {
        reflectances_[i] = std::max(reflectances_[i], reflectance);
      } else {
        lobes_.push_back({part, largest_factor(material, part.most)});
      }
    }
  }

  /// Adds a share of the texels of all materials. Shares within a step are merged at their lowest power.
  void add(const UsedPower& used) {
    const auto [at, is_new] = used_.try_emplace(step_of(used.power), used);
    if (is_new) return;
    UsedPower& known = at->second;
    const double share = known.share + used.share;
    const bool is_less = used.power < known.power;
    if (is_less || (used.power == known.power && used.factor > known.factor)) known = used;
    known.share = share;
  }

  std::vector<UsedPower> used() const {
    std::vector<UsedPower> all;
    for (const auto& [ignored, one] : used_) all.push_back(one);
    return all;
  }

  std::vector<WeightedPower> lobes() && {
    for (std::size_t i = 0; i + 1 < steps_.size(); ++i) {
      if (reflectances_[i] < 0) continue;
      const Range whole{steps_[i], steps_[i + 1]};
      lobes_.push_back({whole, reflectances_[i] * game_normalisation(whole.most)});
    }
    return each_once(std::move(lobes_));
  }

 private:
  std::size_t step_of(double power) const {
    const auto above = std::upper_bound(steps_.begin(), steps_.end(), power);
    return static_cast<std::size_t>(above - steps_.begin()) - 1;
  }

  std::vector<double> steps_ = steps_of_powers();
  std::vector<double> reflectances_ = std::vector<double>(steps_.size(), -1);  ///< negative: none
  std::vector<WeightedPower> lobes_;
  std::map<std::size_t, UsedPower> used_;
};

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
  LobeCollection collection;
  const auto count = static_cast<double>(std::count(has_lobe.begin(), has_lobe.end(), true));
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!has_lobe[i]) continue;
    const Material& material = materials[i];
    collection.add(material);
    for (const PowerShare& used : material.powers)
      collection.add(UsedPower{used.power, largest_factor(material, used.power), used.share / count});
    const auto& f0 = material.f0;
    lobes.textures.insert(material.power_texture);
    lobes.has_schlick = lobes.has_schlick || material.fresnel == FresnelTerm::schlick;
    lobes.is_coloured = lobes.is_coloured || material.has_unread_colours || f0[0] != f0[1] || f0[1] != f0[2];
    lobes.has_metal =
        lobes.has_metal || (material.fresnel == FresnelTerm::schlick && largest_of(f0) > most_of_dielectrics);
  }
  lobes.used = collection.used();
  lobes.all = std::move(collection).lobes();
  return lobes;
}

}  // namespace shadefit::scene
