#include "scene/gltf/glb.hpp"

#include <fmt/format.h>

#include "fit/support/user_error.hpp"

namespace shadefit::scene {
namespace {

constexpr std::size_t glb_header_size = 12, chunk_header_size = 8;
constexpr std::uint32_t glb_magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

/// The little-endian 32-bit number at `offset`; four bytes must be available.
std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return word;
}

/// The part of the bytes that the header declares as the file.
std::string_view declared_part(std::string_view bytes) {
  if (bytes.size() < glb_header_size) {
    throw UserError(
        fmt::format("byte 0: a GLB file begins with {} bytes, and has {}", glb_header_size, bytes.size()));
  }
  if (word_at(bytes, 0) != glb_magic) throw UserError("byte 0: a GLB file begins with 'glTF'");
  const std::uint32_t version = word_at(bytes, 4), length = word_at(bytes, 8);
  if (version != 2) throw UserError(fmt::format("byte 4: version {} of GLB is not 2", version));
  if (length < glb_header_size || length > bytes.size()) {
    throw UserError(
        fmt::format("byte 8: the length {} is not within the file's {} bytes", length, bytes.size()));
  }
  return bytes.substr(0, length);
}

}  // namespace

Glb parse_glb(std::string_view bytes) {
  const std::string_view file = declared_part(bytes);
  Glb glb;
  bool is_first = true;
  for (std::size_t offset = glb_header_size; offset < file.size();) {
    if (file.size() - offset < chunk_header_size)
      throw UserError(fmt::format("byte {}: the file ends within a chunk's header", offset));
    const std::uint32_t length = word_at(file, offset), kind = word_at(file, offset + 4);
    const std::size_t begin = offset + chunk_header_size;
    if (length > file.size() - begin) {
      throw UserError(fmt::format("byte {}: a chunk of {} bytes goes past the end, {} bytes on", offset,
                                  length, file.size() - begin));
    }
    const std::string_view chunk = file.substr(begin, length);
    if (is_first != (kind == json_chunk))
      throw UserError(fmt::format("byte {}: the first chunk, and no other, has to be JSON", offset));
    if (is_first) glb.json = chunk;
    if (kind == binary_chunk && !glb.binary) glb.binary = chunk;
    is_first = false;
    offset = begin + length;
  }
  if (is_first) throw UserError(fmt::format("byte {}: there is no JSON chunk", glb_header_size));
  return glb;
}

}  // namespace shadefit::scene
