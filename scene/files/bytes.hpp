#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// Bytes of a file that are no text.
namespace shadefit::scene {

using Bytes = std::span<const std::uint8_t>;

/// What a text is made of, for as long as it lives.
inline Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Bytes as text, for as long as they live.
inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace shadefit::scene
