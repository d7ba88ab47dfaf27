#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "scene/materials/texture.hpp"

/// Code shared by the PNG and JPEG readers.
namespace shadefit::scene {

struct PictureSize {
  std::uint64_t width, height;
};

/// Called with the size in the header before anything is decoded; throws if it is too large.
using SizeCheck = std::function<void(PictureSize)>;

/// The counts of one channel.
struct ChannelCount {
  Channel channel;
  Histogram counts{};
};

/// Counts consecutive texels of `components` bytes each: grey, grey and alpha, RGB, RGBA.
inline void count_texels(const std::uint8_t* texels, std::size_t number, std::size_t components,
                         std::span<ChannelCount> counted) {
  const bool is_coloured = components >= 3, has_alpha = components % 2 == 0;
  for (ChannelCount& count : counted) {
    if (count.channel == Channel::alpha && !has_alpha) {
      count.counts[255] += static_cast<std::uint32_t>(number);
      continue;
    }
    const std::size_t component = count.channel == Channel::alpha ? components - 1
                                  : is_coloured                   ? static_cast<std::size_t>(count.channel)
                                                                  : 0;
    const std::uint8_t* const end = texels + number * components;
    for (const std::uint8_t* texel = texels; texel != end; texel += components)
      ++count.counts[texel[component]];
  }
}

// Both decode row by row, so they need memory for one row only; but a progressive JPEG needs six bytes per
// texel. Both throw UserError with the decoder's words.

void count_png(Bytes encoded, const SizeCheck& check, std::span<ChannelCount> counted);
void count_jpeg(Bytes encoded, const SizeCheck& check, std::span<ChannelCount> counted);

}  // namespace shadefit::scene
