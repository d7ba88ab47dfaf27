#include "scene/gltf/gltf_images.hpp"

#include <fmt/format.h>

#include <system_error>

#include "fit/input/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "scene/materials/messages.hpp"
#include "scene/materials/uri.hpp"

namespace shadefit::scene {
namespace {

/// The file named by the URI at a place; nothing if the URI is data or remote.
std::optional<std::filesystem::path> file_of_uri(const JsonPlace& place,
                                                 const std::filesystem::path& folder) {
  const std::string_view uri = text_at(place);
  return at_place(words_of(place), [&]() -> std::optional<std::filesystem::path> {
    if (is_data(uri) || is_remote(uri)) return std::nullopt;
    return path_within(folder, percent_decoded(uri));
  });
}

std::string content_of(const JsonPlace& uri, const std::filesystem::path& folder) {
  const auto file = file_of_uri(uri, folder);
  return at_place(words_of(uri),
                  [&] { return file ? read_bounded(*file, most_picture_bytes) : data_of_uri(text_at(uri)); });
}

JsonPlace buffer_of(const JsonPlace& view, const JsonPlace& root) {
  return indexed_element(required_member(view, "buffer"), root, "buffers");
}

}  // namespace

GltfImages::GltfImages(const JsonPlace& root, const std::optional<std::string_view>& binary,
                       const std::filesystem::path& file)
    : root_(root), binary_(binary), folder_(folder_of(file)) {}

const TextureReading& GltfImages::read(const JsonPlace& texture_info, const std::vector<Channel>& channels) {
  const JsonPlace texture = indexed_element(required_member(texture_info, "index"), root_, "textures");
  const auto source = member(texture, "source");
  const auto image = source ? std::optional(indexed_element(*source, root_, "images")) : std::nullopt;
  const std::pair key{image ? image->pointer : texture.pointer, channels};
  const auto known = read_.find(key);
  if (known != read_.end()) return known->second;
  TextureReading reading =
      image ? read_image(*image, channels) : TextureReading{{}, texture.pointer + " has no source"};
  return read_.emplace(key, std::move(reading)).first->second;
}

std::string GltfImages::reason_unknown(const JsonPlace& uri) const {
  const std::string_view text = text_at(uri);
  if (is_remote(text)) return fmt::format("'{}' is not fetched", shortened(text));
  const auto file = file_of_uri(uri, folder_);
  std::error_code ignored;
  if (!file || std::filesystem::exists(*file, ignored)) return {};
  return fmt::format("'{}' is missing",
                     file->lexically_relative(std::filesystem::weakly_canonical(folder_)).string());
}

TextureReading GltfImages::read_image(const JsonPlace& image, std::span<const Channel> channels) {
  const auto uri = member(image, "uri"), view = member(image, "bufferView");
  if (uri.has_value() == view.has_value()) refuse(image, "it must have a uri or a bufferView, and not both");
  const auto place = view ? std::optional(indexed_element(*view, root_, "bufferViews")) : std::nullopt;
  const auto source = place ? member(buffer_of(*place, root_), "uri") : uri;
  if (source) {
    if (std::string reason = reason_unknown(*source); !reason.empty()) return {{}, std::move(reason)};
  }
  const std::string encoded = place ? bytes_of_view(*place) : content_of(*uri, folder_);
  if (picture_format(encoded) == PictureFormat::other) {
    const bool is_file = uri && !is_data(text_at(*uri));
    const std::string name = is_file ? fmt::format("'{}'", text_at(*uri)) : image.pointer;
    return {{}, name + " is neither PNG nor JPEG"};
  }
  return at_place(words_of(image), [&] { return TextureReading{pictures_.ranges(encoded, channels), {}}; });
}

const std::string& GltfImages::data_of_buffer(const JsonPlace& buffer, std::string_view uri) {
  const auto known = data_.find(buffer.pointer);
  if (known != data_.end()) return known->second;
  auto data = at_place(words_of(buffer), [&] { return data_of_uri(uri); });
  return data_.emplace(buffer.pointer, std::move(data)).first->second;
}

std::string GltfImages::bytes_of_view(const JsonPlace& view) {
  const JsonPlace length_place = required_member(view, "byteLength");
  const JsonPlace buffer = buffer_of(view, root_);
  const auto offset_place = member(view, "byteOffset");
  const std::size_t offset = offset_place ? whole_number(*offset_place) : 0,
                    length = whole_number(length_place);
  const auto require_within = [&](std::size_t size) {
    if (offset > size || length > size - offset)
      refuse(view,
             fmt::format("{} bytes from {} on go past the {} of {}", length, offset, size, buffer.pointer));
  };
  require_within(whole_number(required_member(buffer, "byteLength")));
  const auto uri = member(buffer, "uri");
  if (const auto file = uri ? file_of_uri(*uri, folder_) : std::nullopt)
    return at_place(words_of(view), [&] { return read_part(*file, offset, length); });
  if (!uri && !(binary_ && buffer.pointer == "/buffers/0"))
    refuse(buffer, "it has neither a uri nor a chunk BIN");
  const std::string_view content = uri ? data_of_buffer(buffer, text_at(*uri)) : *binary_;
  require_within(content.size());
  return std::string(content.substr(offset, length));
}

}  // namespace shadefit::scene
