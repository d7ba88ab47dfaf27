#include "bench/shading/workload.hpp"

#include <algorithm>

namespace shadefit::shade {
namespace {

/// The cosines of a block: 12 KiB of floats. With their results, and the same in double, they stay in the
/// caches of one core.
constexpr std::size_t samples_of_block = 1024;

/// Blocks of different places and lights.
constexpr std::size_t blocks_of_sphere = 16;

/// The visits of all materials together, unless each material then has less than one for a quarter of the
/// blocks.
constexpr std::size_t wanted_visits = 256;

/// The power below which a share of the texels lies.
double power_at_share(const std::vector<scene::PowerShare>& powers, double share) {
  double below = 0;
  for (const scene::PowerShare& some : powers) {
    below += some.share;
    if (share < below) return some.power;
  }
  return powers.back().power;
}

/// One tile for each of these equal shares. The order has steps of the golden ratio, so that neighbours
/// differ.
double share_of_tile(std::size_t tile, std::size_t tiles) {
  constexpr double golden = 0.6180339887498949;
  const double at = 0.5 + static_cast<double>(tile) * golden;
  const double part = at - static_cast<double>(static_cast<std::size_t>(at));
  const auto count = static_cast<double>(tiles);
  return (static_cast<double>(static_cast<std::size_t>(part * count)) + 0.5) / count;
}

}  // namespace

Workload::Workload(const scene::Scene& scene, int lights)
    : lights_(std::min(static_cast<std::size_t>(lights), most_lights)),
      tiles_(samples_of_block / tile_pixels / lights_),
      blocks_(sphere_blocks(blocks_of_sphere, tiles_, lights_)) {
  const std::size_t all = scene.materials.size(), chosen = std::min(all, most_materials);
  const std::size_t each = std::clamp(wanted_visits / chosen, blocks_of_sphere / 4, 4 * blocks_of_sphere);
  for (std::size_t m = 0; m < chosen; ++m) {
    const std::size_t index = m * all / chosen;
    const scene::Material& material = scene.materials[index];
    for (std::size_t i = 0; i < each; ++i) {
      Visit visit{index, (m * each + i) % blocks_of_sphere, {}};
      auto& [narrow, wide] = visit.alpha;
      for (std::size_t tile = 0; material.is_power_textured() && tile < tiles_; ++tile) {
        const double share = share_of_tile(i * tiles_ + tile, each * tiles_);
        const auto alpha = static_cast<float>(alpha_of_power(power_at_share(material.powers, share)));
        narrow.insert(narrow.end(), tile_pixels, alpha);
      }
      wide.assign(narrow.begin(), narrow.end());
      visits_.push_back(std::move(visit));
    }
  }
  // One block after the other, so that its cosines stay in the first cache.
  std::ranges::stable_sort(visits_, {}, &Visit::block);
}

}  // namespace shadefit::shade
