#pragma once

#include <algorithm>
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

/// The least and the largest code of one channel.
struct ChannelCodes {
  Channel channel;
  std::uint8_t least = 255, most = 0;
};

/// Takes consecutive texels of `components` bytes each: grey, grey and alpha, RGB, RGBA.
inline void take_texels(const std::uint8_t* texels, std::size_t number, std::size_t components,
                        std::span<ChannelCodes> taken) {
  const bool is_coloured = components >= 3, has_alpha = components % 2 == 0;
  for (ChannelCodes& codes : taken) {
    if (codes.channel == Channel::alpha && !has_alpha) {
      codes.most = 255;
      continue;
    }
    const std::size_t component = codes.channel == Channel::alpha ? components - 1
                                  : is_coloured                   ? static_cast<std::size_t>(codes.channel)
                                                                  : 0;
    const std::uint8_t* const end = texels + number * components;
    for (const std::uint8_t* texel = texels; texel != end; texel += components) {
      codes.least = std::min(codes.least, texel[component]);
      codes.most = std::max(codes.most, texel[component]);
    }
  }
}

// Both decode row by row, so they need memory for one row only; but a progressive JPEG needs six bytes per
// texel. Both throw UserError with the decoder's words.

void take_png(std::string_view encoded, const SizeCheck& check, std::span<ChannelCodes> taken);
void take_jpeg(std::string_view encoded, const SizeCheck& check, std::span<ChannelCodes> taken);

}  // namespace shadefit::scene
