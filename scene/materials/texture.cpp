#include "scene/materials/texture.hpp"

#include <fmt/format.h>

#include "fit/support/user_error.hpp"
#include "scene/materials/texels.hpp"

namespace shadefit::scene {

PictureFormat picture_format(std::string_view encoded) {
  if (encoded.starts_with("\x89PNG\r\n\x1A\n")) return PictureFormat::png;
  return encoded.starts_with("\xFF\xD8\xFF") ? PictureFormat::jpeg : PictureFormat::other;
}

std::vector<Range> PictureReader::ranges(std::string_view encoded, std::span<const Channel> channels) {
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
  std::vector<ChannelCodes> taken;
  for (const Channel channel : channels) taken.push_back({channel});
  const PictureFormat format = picture_format(encoded);
  if (format == PictureFormat::other) throw UserError("the picture is neither PNG nor JPEG");
  (format == PictureFormat::png ? take_png : take_jpeg)(encoded, check, taken);
  std::vector<Range> found;
  for (const ChannelCodes& codes : taken) found.push_back({codes.least / 255.0, codes.most / 255.0});
  return found;
}

}  // namespace shadefit::scene
