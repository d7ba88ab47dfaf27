#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/files/bytes.hpp"

/// How often each code is in a channel of a picture: all that a material wants of a texture.
namespace shadefit::scene {

enum class Channel { red, green, blue, alpha };

/// How many texels have each of the 256 codes.
using Histogram = std::array<std::uint32_t, 256>;

/// 8192 x 8192, the largest texture that most graphics processors of the last ten years take. A header may
/// claim more, and a few thousand bytes of PNG may hold it.
inline constexpr std::uint64_t most_pixels = 64 << 20;

/// Of all the pictures of a scene together: about a minute's work. Nothing else bounds what a scene that is
/// full of small files of large pictures takes.
inline constexpr std::uint64_t most_scene_pixels = std::uint64_t{4} << 30;

/// What a picture is by its first bytes.
enum class PictureFormat { png, jpeg, other };
PictureFormat picture_format(Bytes encoded);

/// Reads the pictures of one scene, and keeps count of them.
class PictureReader {
 public:
  explicit PictureReader(std::uint64_t pixels = most_scene_pixels) : pixels_left_(pixels) {}

  /// The histograms of channels of a PNG or a JPEG, in the order of `channels`. Of a grey picture each colour
  /// is the grey; without an alpha that is 255 everywhere; of 16 bits a channel the nearest codes of 8. No
  /// colour space is applied. The size is read first, and nothing is decoded of a picture that is too large.
  /// Throws UserError: neither PNG nor JPEG, damaged, more than `most_pixels`, more than what is left for the
  /// scene.
  std::vector<Histogram> histograms(Bytes encoded, std::span<const Channel> channels);

 private:
  std::uint64_t pixels_left_;
};

}  // namespace shadefit::scene
