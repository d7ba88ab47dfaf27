#pragma once

#include <cstdint>
#include <span>
#include <string_view>

/// Bytes of a binary file.
namespace shadefit::scene {

using Bytes = std::span<const std::uint8_t>;

/// The bytes of a text; valid while the text lives.
inline Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Bytes as text; valid while the bytes live.
inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace shadefit::scene
