#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bench/device/scenes/scene_shader.hpp"
#include "bench/device/spirv.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/shading/ways.hpp"

/// A graphics device that shades a scene.
namespace shadefit::device {

/// A pixel under its first light, and what its texture holds for the power.
struct ShaderPixel {
  float n_dot_h, n_dot_l, l_dot_h, stored;
  std::uint32_t material;  ///< among those of the pass
};

/// The pixels of a block: one light, one material. A roughness is computed from the block's alpha in double
/// and rounded to float. This changes its power by up to 4e-7, relative; for a gloss g, by 1/(1 - g) times
/// that.
std::vector<ShaderPixel> pixels_of(const shade::Block<float>& block, scene::PowerTexture source,
                                   const scene::Conventions& conventions);

/// The largest pass: at least one pixel.
struct PassSize {
  std::size_t pixels, materials;
};

class SceneDevice {
 public:
  /// A device with readable buffers that are large enough for the largest pass: of the choice only `place`
  /// and `is_watched` count. Throws as `VulkanDevice` does.
  SceneDevice(const DeviceChoice& choice, const PassSize& most);

  VulkanDevice& device() { return device_; }

  Program load(const SceneShader& shader) const;

  /// Writes the input of the next passes.
  void put_pixels(std::span<const ShaderPixel> pixels);
  void put_materials(std::span<const ShaderMaterial> materials);

  /// Shades all pixels under `lights` lights each, in dispatches of at most `at_once` pixels, and returns
  /// their seconds. If `at_once` is 0, the dispatches grow as long as they are short.
  double pass(const Program& program, std::uint32_t lights, std::uint32_t at_once = 0);

  /// Channel i of the output, one float for each pixel.
  std::span<const std::uint32_t> channel(std::size_t i);

  /// A way that shades each block in a pass of its own. This device must outlive it.
  shade::Way way(const scene::Scene& scene, const SceneShader& shader);

 private:
  VulkanDevice device_;
  ShaderCompiler compiler_;
  std::uint32_t pixels_ = 0;
};

}  // namespace shadefit::device
