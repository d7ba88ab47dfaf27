#pragma once

#include <cstddef>

/// What readers of all formats refuse to go beyond.
namespace shadefit::scene {

/// Of a scene, all its files together. A material takes some thousand bytes, and its text may have nine:
/// without a limit a file of 64 MiB would take all memory.
inline constexpr std::size_t most_materials = 65536;

}  // namespace shadefit::scene
