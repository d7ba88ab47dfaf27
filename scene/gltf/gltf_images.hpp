#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/materials/json_place.hpp"
#include "scene/materials/texture.hpp"

/// The pictures of a glTF document: in a buffer, in a data URI or in a separate file.
namespace shadefit::scene {

/// The result of reading a texture: ranges, or the reason why it is unknown, such as "'a.png' is
/// missing".
struct TextureReading {
  std::vector<Range> channels;  ///< as requested; empty if unknown
  std::string unknown;
};

/// Reads each picture once, and only when it is requested.
class GltfImages {
 public:
  /// `binary` is the chunk BIN of a .glb, which must outlive this object, like the document.
  GltfImages(const JsonPlace& root, const std::optional<std::string_view>& binary,
             const std::filesystem::path& file);

  /// The texture that a texture info names: an object with an index. A missing or remote file, another format
  /// and a texture of an extension are unknown; damaged pictures, indices out of range, and names outside the
  /// scene's folder throw UserError.
  const TextureReading& read(const JsonPlace& texture_info, const std::vector<Channel>& channels);

 private:
  TextureReading read_image(const JsonPlace& image, std::span<const Channel> channels);
  /// Why the bytes at a URI are unknown; empty if they are there.
  std::string reason_unknown(const JsonPlace& uri) const;
  std::string bytes_of_view(const JsonPlace& view);
  const std::string& data_of_buffer(const JsonPlace& buffer, std::string_view uri);

  JsonPlace root_;
  std::optional<std::string_view> binary_;
  std::filesystem::path folder_;
  PictureReader pictures_;
  std::map<std::pair<std::string, std::vector<Channel>>, TextureReading> read_;  ///< by pointer and channels
  std::map<std::string, std::string> data_;  ///< of buffers that are data URIs, by pointer
};

}  // namespace shadefit::scene
