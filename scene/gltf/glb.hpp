#pragma once

#include <optional>
#include <string_view>

/// The container of binary glTF.
namespace shadefit::scene {

/// The chunks of a GLB file, as parts of its bytes.
struct Glb {
  std::string_view json;
  std::optional<std::string_view> binary;  ///< if the file has a chunk BIN
};

/// The chunks of the file `bytes`. Other chunks, and bytes beyond the length in the header, are ignored.
/// Throws UserError naming the byte and the rule: magic, version 2, a length or a chunk past the end, a first
/// chunk that is not JSON. Source: Khronos Group 2021, "glTF 2.0 Specification", section 4.4.
Glb parse_glb(std::string_view bytes);

}  // namespace shadefit::scene
