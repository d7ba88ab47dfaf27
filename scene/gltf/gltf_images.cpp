#include "scene/gltf/gltf_images.hpp"

#include <fmt/format.h>

#include <system_error>

#include "fit/input/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "scene/files/messages.hpp"
#include "scene/files/uri.hpp"

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

bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

}  // namespace

GltfImages::GltfImages(const JsonPlace& root, const std::optional<Bytes>& binary,
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

TextureReading GltfImages::read_image(const JsonPlace& image, std::span<const Channel> channels) {
  const auto uri = member(image, "uri"), view = member(image, "bufferView");
  if (uri.has_value() == view.has_value()) refuse(image, "it must have a uri or a bufferView, and not both");
  const auto missing = [&](const std::filesystem::path& path) {
    const std::string name = name_in_folder(path);
    named_as_unknown_.insert(name);
    return TextureReading{{}, fmt::format("'{}' is missing", name)};
  };
  if (view) {
    const JsonPlace found = indexed_element(*view, root_, "bufferViews");
    const JsonPlace buffer = indexed_element(required_member(found, "buffer"), root_, "buffers");
    const auto buffer_uri = member(buffer, "uri");
    const auto file = buffer_uri ? file_of_uri(*buffer_uri, folder_) : std::nullopt;
    if (file && !is_there(*file)) return missing(*file);
    if (buffer_uri && is_remote(text_at(*buffer_uri)))
      return {{}, fmt::format("'{}' is not fetched", shortened(text_at(*buffer_uri)))};
    return decode(image, image.pointer, bytes_of(bytes_of_view(found)), channels);
  }
  const std::string_view text = text_at(*uri);
  if (is_remote(text)) return {{}, fmt::format("'{}' is not fetched", shortened(text))};
  if (const auto file = file_of_uri(*uri, folder_)) {
    if (!is_there(*file)) return missing(*file);
    const std::string encoded =
        at_place(words_of(*uri), [&] { return read_bounded(*file, most_picture_bytes); });
    return decode(image, fmt::format("'{}'", text), bytes_of(encoded), channels);
  }
  const auto data = at_place(words_of(*uri), [&] { return data_of_uri(text); });
  return decode(image, image.pointer, bytes_of(data), channels);
}

TextureReading GltfImages::decode(const JsonPlace& image, const std::string& name, Bytes encoded,
                                  std::span<const Channel> channels) {
  if (picture_format(encoded) == PictureFormat::other) return {{}, name + " is neither PNG nor JPEG"};
  return at_place(words_of(image), [&] {
    return TextureReading{pictures_.histograms(encoded, channels), {}};
  });
}

const std::string& GltfImages::data_of_buffer(const JsonPlace& buffer, std::string_view uri) {
  const auto known = data_.find(buffer.pointer);
  if (known != data_.end()) return known->second;
  auto data = at_place(words_of(buffer), [&] { return data_of_uri(uri); });
  return data_.emplace(buffer.pointer, std::move(data)).first->second;
}

std::string GltfImages::bytes_of_view(const JsonPlace& view) {
  const JsonPlace length_place = required_member(view, "byteLength");
  const JsonPlace buffer = indexed_element(required_member(view, "buffer"), root_, "buffers");
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
  const std::string_view content = uri ? data_of_buffer(buffer, text_at(*uri)) : text_of(*binary_);
  require_within(content.size());
  return std::string(content.substr(offset, length));
}

std::string GltfImages::name_in_folder(const std::filesystem::path& file) const {
  return file.lexically_relative(std::filesystem::weakly_canonical(folder_)).string();
}

std::vector<std::string> GltfImages::missing_files() const {
  std::set<std::string> names;
  for (const std::string_view key : {"buffers", "images"}) {
    for_each_element(root_, key, [&](const JsonPlace& place) {
      const auto uri = member(place, "uri");
      const auto file = uri ? file_of_uri(*uri, folder_) : std::nullopt;
      if (!file || is_there(*file)) return;
      const std::string name = name_in_folder(*file);
      if (!named_as_unknown_.contains(name)) names.insert(name);
    });
  }
  return {names.begin(), names.end()};
}

}  // namespace shadefit::scene
