#include <cstddef>
#include <cstdint>

#include "fit/support/user_error.hpp"
#include "scene/gltf/read_gltf.hpp"
#include "tests/fuzz/scene_holds.hpp"

// One input is a .glb if it begins as one, else a .gltf. The folder that it would be in does not exist.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  const char* const file = content.starts_with("glTF") ? "/no such folder/a.glb" : "/no such folder/a.gltf";
  try {
    fuzz::require_holds(scene::read_gltf(content, file, {.has_features = true}));
    fuzz::require_holds(
        scene::read_gltf(content, file, {.is_roughness_squared = false, .is_gloss_exponential = true}));
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
