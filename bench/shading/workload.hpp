#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "bench/shading/geometry.hpp"
#include "bench/shading/shaded_scene.hpp"
#include "scene/materials/material.hpp"

/// The shaded samples, the same in every run: tiles of a sphere in each of the scene's materials.
namespace shadefit::shade {

/// One block in one material.
struct Visit {
  std::size_t material;  ///< of the scene's
  std::size_t block;
  /// The roughness of each pixel of a texture, tile by tile; else empty. A float, in both formats.
  std::tuple<std::vector<float>, std::vector<double>> alpha;
};

/// Every material has the same number of visits. A tile has one power, like a magnified texture; the tiles of
/// a material have its powers in proportion to their shares.
class Workload {
 public:
  /// Under `lights` lights, at most `most_lights` of which are shaded. Of more than `most_materials`
  /// materials, that many are chosen evenly.
  Workload(const scene::Scene& scene, int lights);

  const std::vector<Visit>& visits() const { return visits_; }
  std::size_t samples() const { return visits_.size() * samples_of_visit(); }
  std::size_t samples_of_visit() const { return tiles_ * lights_ * tile_pixels; }
  std::size_t tiles() const { return tiles_; }
  std::size_t lights() const { return lights_; }

  /// The inputs of a visit.
  template <class Real>
  Block<Real> block(const Visit& visit) const {
    Block<Real> block = blocks_[visit.block].template block<Real>();
    const auto& alpha = std::get<std::vector<Real>>(visit.alpha);
    block.alpha = alpha.empty() ? nullptr : alpha.data();
    return block;
  }

  static constexpr std::size_t most_materials = 256;

 private:
  std::size_t lights_, tiles_;
  std::vector<Cosines> blocks_;
  std::vector<Visit> visits_;
};

/// A block with a tile for each light of its tiles, each under that light alone.
template <class Real>
class SingleLights {
 public:
  explicit SingleLights(const Block<Real>& block) : block_(block) {
    block_.tiles = block.tiles * block.lights;
    block_.lights = 1;
    for (std::size_t i = 0; block.alpha != nullptr && i < block_.tiles; ++i) {
      const Real* const pixels = block.alpha + i / block.lights * tile_pixels;
      alpha_.insert(alpha_.end(), pixels, pixels + tile_pixels);
    }
  }
  Block<Real> block(const std::array<Real*, 3>& out = {}) const {
    Block<Real> block = block_;
    block.alpha = alpha_.empty() ? nullptr : alpha_.data();
    block.out = out;
    return block;
  }

 private:
  Block<Real> block_;
  std::vector<Real> alpha_;  ///< of each sample: that of its pixel
};

/// The results of a visit.
template <class Real>
class Results {
 public:
  explicit Results(std::size_t tiles) { channels_.fill(std::vector<Real>(tiles * tile_pixels)); }
  std::array<Real*, 3> out() { return {channels_[0].data(), channels_[1].data(), channels_[2].data()}; }
  void clear() { channels_.fill(std::vector<Real>(channels_[0].size())); }
  const std::vector<Real>& channel(std::size_t i) const { return channels_[i]; }

 private:
  std::array<std::vector<Real>, 3> channels_;
};

}  // namespace shadefit::shade
