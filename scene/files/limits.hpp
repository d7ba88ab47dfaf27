#pragma once

#include <cstddef>

/// Limits of the readers of all formats.
namespace shadefit::scene {

/// For all files of a scene together. A material takes some thousand bytes in memory but may take only nine
/// in a file: without a limit, a file of 64 MiB could use all memory.
inline constexpr std::size_t most_materials = 65536;

}  // namespace shadefit::scene
