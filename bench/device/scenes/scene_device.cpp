#include "bench/device/scenes/scene_device.hpp"

#include <algorithm>
#include <bit>

#include "approx/microfacet.hpp"
#include "bench/device/dispatches.hpp"

namespace shadefit::device {

std::vector<ShaderPixel> pixels_of(const shade::Block<float>& block, scene::PowerTexture source,
                                   const scene::Conventions& conventions) {
  std::vector<ShaderPixel> pixels;
  for (std::size_t i = 0; i < block.tiles * shade::tile_pixels; ++i) {
    float stored = 0;
    if (block.alpha != nullptr)
      stored =
          stored_of_power(blinn_phong_exponent(static_cast<double>(block.alpha[i])), source, conventions);
    pixels.push_back({block.n_dot_h[i], block.n_dot_l[i], block.l_dot_h[i], stored, 0});
  }
  return pixels;
}

SceneDevice::SceneDevice(const DeviceChoice& choice, const PassSize& most)
    : device_({.place = choice.place,
               .words = planes_of_pixel * most.pixels + words_of_material * most.materials,
               .is_watched = choice.is_watched}) {}

Program SceneDevice::load(const SceneShader& shader) const {
  return device_.load(compiler_.spirv(glsl_of(shader), ShaderLanguage::glsl));
}

void SceneDevice::put_pixels(std::span<const ShaderPixel> pixels) {
  pixels_ = static_cast<std::uint32_t>(pixels.size());
  const auto plane = [&](std::size_t i) { return device_.input().subspan(i * pixels.size(), pixels.size()); };
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const ShaderPixel& pixel = pixels[i];
    plane(0)[i] = std::bit_cast<std::uint32_t>(pixel.n_dot_h);
    plane(1)[i] = std::bit_cast<std::uint32_t>(pixel.n_dot_l);
    plane(2)[i] = std::bit_cast<std::uint32_t>(pixel.l_dot_h);
    plane(3)[i] = std::bit_cast<std::uint32_t>(pixel.stored);
    plane(4)[i] = pixel.material;
  }
}

void SceneDevice::put_materials(std::span<const ShaderMaterial> materials) {
  auto place = device_.input().subspan(planes_of_pixel * pixels_);
  for (const ShaderMaterial& material : materials) {
    std::ranges::copy(std::bit_cast<MaterialWords>(material), place.begin());
    place = place.subspan(words_of_material);
  }
}

double SceneDevice::pass(const Program& program, std::uint32_t lights, std::uint32_t at_once) {
  double seconds = 0;
  const auto dispatch = [&](std::uint64_t from, std::uint64_t size) {
    const auto first = static_cast<std::uint32_t>(from), count = static_cast<std::uint32_t>(size);
    const double took = seconds_of_dispatch(device_.info(), [&] {
      return device_.run(program, count, {first, count, lights, pixels_});
    });
    seconds += took;
    return took;
  };
  if (at_once == 0) {
    in_short_dispatches(pixels_, most_threads, dispatch);
  } else {
    for (std::uint32_t from = 0; from < pixels_; from += at_once)
      dispatch(from, std::min(at_once, pixels_ - from));
  }
  return seconds;
}

std::span<const std::uint32_t> SceneDevice::channel(std::size_t i) {
  return device_.output().subspan(i * pixels_, pixels_);
}

shade::Way SceneDevice::way(const scene::Scene& scene, const SceneShader& shader) {
  const auto shade = [this, program = load(shader), shader, conventions = scene.conventions](
                         const shade::Block<float>& block, std::size_t material) {
    const ShaderMaterial& made = shader.materials[material];
    if (made.has_lobe == 0) return;
    put_pixels(pixels_of(block, made.source, conventions));
    put_materials(std::span(&made, 1));
    pass(program, 1);
    for (std::size_t i = 0; i < (shader.is_coloured ? 3U : 1U); ++i)
      std::ranges::transform(channel(i), block.out.at(i),
                             [](std::uint32_t bits) { return std::bit_cast<float>(bits); });
  };
  return {shade, shader.is_coloured};
}

}  // namespace shadefit::device
