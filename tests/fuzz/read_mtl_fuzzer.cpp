#include <cstddef>
#include <cstdint>

#include "fit/support/user_error.hpp"
#include "scene/gltf/read_mtl.hpp"
#include "tests/fuzz/scene_holds.hpp"

// One input is an .mtl. The folder that it would be in does not exist.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  const char* const file = "/no such folder/a.mtl";
  try {
    fuzz::require_holds(scene::read_mtl(content, file, {.has_features = true}));
    fuzz::require_holds(scene::read_mtl(content, file, {.are_maps_pbr = true}));
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
