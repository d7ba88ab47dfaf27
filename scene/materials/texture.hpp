#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scene/materials/material.hpp"

/// The ranges of the channels of a picture: all that a material needs from a texture.
namespace shadefit::scene {

enum class Channel { red, green, blue, alpha };

/// A texture of which nothing is known.
inline constexpr Range unknown_texture{0, 1};

/// 8192 x 8192, the largest texture that most graphics processors of the last ten years accept. A header may
/// claim more, and a few thousand bytes of PNG can hold it.
inline constexpr std::uint64_t most_pixels = 64 << 20;

/// The size of an uncompressed picture of `most_pixels` with four channels: no file is larger.
inline constexpr std::uintmax_t most_picture_bytes = 4 * most_pixels;

/// For all pictures of a scene together: about a minute's work. Nothing else limits the time for many small
/// files with large pictures.
inline constexpr std::uint64_t most_scene_pixels = std::uint64_t{4} << 30;

/// The format of a picture, by its first bytes.
enum class PictureFormat { png, jpeg, other };
PictureFormat picture_format(std::string_view encoded);

/// Reads the pictures of one scene and limits their pixels.
class PictureReader {
 public:
  explicit PictureReader(std::uint64_t pixels = most_scene_pixels) : pixels_left_(pixels) {}

  /// The values in [0, 1] of channels of a PNG or a JPEG, in the order of `channels`. In a grey picture all
  /// colours are the grey value; a missing alpha is 1; 16-bit channels are rounded to 8 bits. No colour space
  /// is applied. The size is read first, and a picture that is too large is not decoded. Throws UserError for
  /// a file that is neither PNG nor JPEG, for a damaged one, and for more pixels than `most_pixels` or than
  /// remain for the scene.
  std::vector<Range> ranges(std::string_view encoded, std::span<const Channel> channels);

 private:
  std::uint64_t pixels_left_;
};

}  // namespace shadefit::scene
