#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "scene/textures/texture.hpp"

/// What the readers of the two formats of pictures have in common.
namespace shadefit::scene {

struct PictureSize {
  std::uint64_t width, height;
};

/// Called with the size that the header says, before anything is decoded; throws where it is too large.
using SizeCheck = std::function<void(PictureSize)>;

/// What is counted of texels: a channel each.
struct ChannelCount {
  Channel channel;
  Histogram counts{};
};

/// Counts texels that follow each other, `components` bytes each: grey, grey and alpha, RGB, RGBA.
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

// Both decode row by row, so that memory is that of a row; but a progressive JPEG has six bytes a texel. Both
// throw UserError with the decoder's words.

void count_png(Bytes encoded, const SizeCheck& check, std::span<ChannelCount> counted);
void count_jpeg(Bytes encoded, const SizeCheck& check, std::span<ChannelCount> counted);

}  // namespace shadefit::scene
