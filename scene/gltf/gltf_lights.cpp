#include "scene/gltf/gltf_lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "scene/files/short_text.hpp"

namespace shadefit::scene {
namespace {

/// "'sun' (100000 lux)", if the light is or may become brighter than 1; else empty.
std::string bright_light(const JsonPlace& light, const std::set<std::string>& animated) {
  const double intensity = number_or(light, "intensity", 0, std::numeric_limits<double>::infinity(), 1);
  const bool is_animated = animated.contains(light.pointer + "/intensity");
  if (intensity <= 1 && !is_animated) return {};
  const auto name = member(light, "name"), type = member(light, "type");
  const bool is_directional = type && text_at(*type) == "directional";
  return fmt::format("{} ({:g} {}{})", name ? fmt::format("'{}'", shortened(text_at(*name))) : light.pointer,
                     intensity, is_directional ? "lux" : "candela", is_animated ? ", animated" : "");
}

std::string remark_on(const std::vector<std::string>& bright) {
  if (bright.empty()) return {};
  constexpr std::size_t most_named = 4;
  std::string names = bright.front();
  for (std::size_t i = 1; i < std::min(bright.size(), most_named); ++i) names += ", " + bright[i];
  if (bright.size() > most_named) names += fmt::format(" and {} more", bright.size() - most_named);
  return fmt::format(
      "lights above 1: {}. The tolerance is for a light of 1, which shows white: an error of these is as many "
      "times larger before exposure",
      names);
}

}  // namespace

/// Nodes are read as a flat list without their hierarchy, so cycles do no harm.
GltfLights read_gltf_lights(const JsonPlace& root, const std::set<std::string>& animated) {
  const nlohmann::json nothing = nlohmann::json::object();
  const JsonPlace holder = extension(root, "KHR_lights_punctual")
                               .value_or(JsonPlace{&nothing, "/extensions/KHR_lights_punctual", root.file});
  std::set<std::size_t> used;
  int referenced = 0;
  const auto nodes = member(root, "nodes");
  for (std::size_t i = 0; nodes && i < element_count(*nodes); ++i) {
    const auto node = extension(element(*nodes, i), "KHR_lights_punctual");
    if (!node) continue;
    const JsonPlace index = required_member(*node, "light");
    indexed_element(index, holder, "lights");
    used.insert(whole_number(index));
    ++referenced;
  }
  const auto lights = member(holder, "lights");
  const std::size_t defined = lights ? element_count(*lights) : 0;
  std::vector<std::string> bright;
  for (std::size_t i = 0; i < defined; ++i) {
    if (referenced > 0 && !used.contains(i)) continue;
    const std::string light = bright_light(element(*lights, i), animated);
    if (!light.empty()) bright.push_back(light);
  }
  return {referenced > 0 ? referenced : static_cast<int>(defined), remark_on(bright)};
}

}  // namespace shadefit::scene
