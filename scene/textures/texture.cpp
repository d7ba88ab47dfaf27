#include "scene/textures/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fit/support/user_error.hpp"
#include "scene/textures/texels.hpp"

namespace shadefit::scene {
namespace {

template <std::size_t N>
bool begins_with(Bytes bytes, const std::array<std::uint8_t, N>& signature) {
  return bytes.size() >= N && std::equal(signature.begin(), signature.end(), bytes.begin());
}

}  // namespace

PictureFormat picture_format(Bytes encoded) {
  constexpr std::array<std::uint8_t, 8> png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  constexpr std::array<std::uint8_t, 3> jpeg{0xFF, 0xD8, 0xFF};
  if (begins_with(encoded, png)) return PictureFormat::png;
  return begins_with(encoded, jpeg) ? PictureFormat::jpeg : PictureFormat::other;
}

std::vector<Histogram> PictureReader::histograms(Bytes encoded, std::span<const Channel> channels) {
  const SizeCheck check = [&](PictureSize size) {
    // Both formats store width and height in at most 31 bits, so the product is exact.
    const std::uint64_t pixels = size.width * size.height;
    if (pixels > most_pixels) {
      throw UserError(fmt::format("the picture has {} x {} pixels, more than {} together", size.width,
                                  size.height, most_pixels));
    }
    if (pixels > pixels_left_) {
      throw UserError(
          fmt::format("with its {} x {} pixels the pictures of the scene have more than may be read together",
                      size.width, size.height));
    }
    pixels_left_ -= pixels;
  };
  std::vector<ChannelCount> counted;
  for (const Channel channel : channels) counted.push_back({channel});
  switch (picture_format(encoded)) {
    case PictureFormat::png:
      count_png(encoded, check, counted);
      break;
    case PictureFormat::jpeg:
      count_jpeg(encoded, check, counted);
      break;
    case PictureFormat::other:
      throw UserError("the picture is neither PNG nor JPEG");
  }
  std::vector<Histogram> found;
  for (const ChannelCount& count : counted) found.push_back(count.counts);
  return found;
}

}  // namespace shadefit::scene
