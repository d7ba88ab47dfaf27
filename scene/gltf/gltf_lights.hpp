#pragma once

#include <set>
#include <string>

#include "scene/files/json_place.hpp"

/// The lights of a glTF document.
namespace shadefit::scene {

struct GltfLights {
  int count = 0;  ///< the lights of nodes; if nodes have none, the defined lights
  /// The lights that are brighter than 1, the light that the tolerance assumes; empty if there are none.
  std::string remark = {};
};

/// The lights of KHR_lights_punctual. `animated` holds the JSON pointers that are animated. Throws UserError
/// naming file, place and rule. Source: Khronos Group 2018, "KHR_lights_punctual".
GltfLights read_gltf_lights(const JsonPlace& root, const std::set<std::string>& animated);

}  // namespace shadefit::scene
