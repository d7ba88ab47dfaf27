#include <fmt/format.h>

#include <array>
#include <limits>

#include "scene/gltf/gltf_material.hpp"

namespace shadefit::scene {
namespace {

constexpr double finite = std::numeric_limits<double>::max();

/// An extension that changes nothing while its factor is `neutral`, which is also the factor's default.
struct Lobe {
  std::string_view extension, factor, feature;
  double neutral = 0;
};
constexpr std::array lobes{Lobe{"KHR_materials_anisotropy", "anisotropyStrength", "anisotropy"},
                           Lobe{"KHR_materials_clearcoat", "clearcoatFactor", "clear coat"},
                           Lobe{"KHR_materials_iridescence", "iridescenceFactor", "iridescence"},
                           Lobe{"KHR_materials_sheen", "sheenColorFactor", "sheen"}};
constexpr std::array lobes_of_dielectrics{
    Lobe{"KHR_materials_ior", "ior", "ior", 1.5},
    Lobe{"KHR_materials_specular", "specularFactor", "specular", 1},
    Lobe{"KHR_materials_specular", "specularColorFactor", "specular", 1},
    Lobe{"KHR_materials_transmission", "transmissionFactor", "transmission"},
    Lobe{"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", "diffuse transmission"}};
constexpr Lobe volume{"KHR_materials_volume", "thicknessFactor", "volume"};
constexpr Lobe dispersion{"KHR_materials_dispersion", "dispersion", "dispersion"};

struct FeatureReading {
  const GltfReading& gltf;
  Features found = {};

  bool is_animated(const JsonPlace& object, std::string_view key) const {
    return gltf.animated.contains(fmt::format("{}/{}", object.pointer, key));
  }

  /// Whether a number, or any number of a colour, is or may become another than `neutral`.
  bool differs(const JsonPlace& object, std::string_view key, double neutral, double unsaid) const {
    if (is_animated(object, key)) return true;
    const auto value = member(object, key);
    if (!value) return unsaid != neutral;
    if (!value->value->is_array()) return number_within(*value, -finite, finite) != neutral;
    bool is_other = false;
    for_each_element(object, key, [&](const JsonPlace& number) {
      is_other = number_within(number, -finite, finite) != neutral || is_other;
    });
    return is_other;
  }

  /// A texture times its factor, with its transform. Returns whether it is needed.
  bool texture(const JsonPlace& object, std::string_view key, const std::string& feature, bool is_factor_on) {
    const auto info = member(object, key);
    if (!info || !is_factor_on || !differs(*info, "scale", 0, 1) || !differs(*info, "strength", 0, 1))
      return false;
    found.insert(feature);
    if (const auto moved = extension(*info, "KHR_texture_transform")) {
      if (differs(*moved, "offset", 0, 0) || differs(*moved, "rotation", 0, 0) ||
          differs(*moved, "scale", 1, 1))
        found.insert("texture transform");
    }
    return true;
  }

  /// An extension with all its textures as one feature. The factor of "xTexture" is "xFactor", if there is
  /// one; that of a roughness is 0 by default.
  bool lobe(const JsonPlace& material, const Lobe& lobe) {
    const auto object = extension(material, lobe.extension);
    bool is_needed = object && differs(*object, lobe.factor, lobe.neutral, lobe.neutral);
    if (!object || (!is_needed && lobe.neutral == 0)) return false;
    for (const auto& [key, ignored] : object->value->items()) {
      if (!key.ends_with("Texture")) continue;
      const std::string factor = key.substr(0, key.size() - 7) + "Factor";
      const bool is_factor_on = differs(*object, factor, 0, key.ends_with("RoughnessTexture") ? 0 : 1);
      is_needed = texture(*object, key, fmt::format("{} texture", lobe.feature), is_factor_on) || is_needed;
    }
    if (is_needed) found.emplace(lobe.feature);
    return is_needed;
  }

  /// The base colour, its alpha, and the sides that are seen. The keys of the colour begin with `name`.
  void surface(const JsonPlace& material, const JsonPlace& object, const std::string& name,
               bool has_vertex_colours) {
    const std::string factor = name + "Factor", map = name + "Texture";
    const auto colour = member(object, factor), mode = member(material, "alphaMode"),
               sides = member(material, "doubleSided");
    const bool is_varied = has_vertex_colours || member(object, map) || is_animated(object, factor);
    bool is_seen =
        colour_or_white(object, factor, 4, 1) != std::array<double, 3>{} || is_animated(object, factor);
    const double alpha = is_varied ? 0 : colour ? number_within(element(*colour, 3), 0, 1) : 1;
    const std::string_view words = mode ? text_at(*mode) : "OPAQUE";
    const bool is_mask = words == "MASK", is_blend = words == "BLEND";
    if (!is_mask && !is_blend && words != "OPAQUE") refuse(*mode, "it must be OPAQUE, MASK or BLEND");
    if ((is_blend && alpha < 1) || (is_mask && alpha < number_or(material, "alphaCutoff", 0, finite, 0.5))) {
      found.insert(is_mask ? "alpha mask" : "alpha blend");
      is_seen = true;
    }
    texture(object, map, "base colour texture", is_seen);
    if (has_vertex_colours && is_seen) found.insert("vertex colours");
    if (sides && !sides->value->is_boolean()) refuse(*sides, "it must be true or false");
    if (sides && sides->value->get<bool>()) found.insert("double sided");
  }

  /// Returns whether all is metal.
  bool metallic_roughness(const JsonPlace& object) {
    const bool is_metal = !differs(object, "metallicFactor", 1, 1);
    const std::string_view key = "metallicRoughnessTexture";
    const auto info = member(object, key);
    if (!info) return is_metal;
    const auto& channels = gltf.images.read(*info, {Channel::green, Channel::blue}).channels;
    const Range roughness = channels.empty() ? unknown_texture : channels[0];
    const Range metallic = channels.empty() ? unknown_texture : channels[1];
    if (!roughness.is_constant())
      texture(object, key, "roughness texture", differs(object, "roughnessFactor", 0, 1));
    if (!metallic.is_constant())
      texture(object, key, "metallic texture", differs(object, "metallicFactor", 0, 1));
    return is_metal && metallic.least == 1;
  }
};

}  // namespace

Features read_gltf_features(const JsonPlace& place, bool has_vertex_colours, const GltfReading& gltf) {
  FeatureReading reading{gltf};
  const JsonPlace object = member_or_empty(place, "pbrMetallicRoughness");
  const auto gloss = extension(place, "KHR_materials_pbrSpecularGlossiness");
  if (extension(place, "KHR_materials_unlit")) {
    reading.surface(place, object, "baseColor", has_vertex_colours);
    reading.found.insert("unlit");
    return reading.found;
  }
  reading.surface(place, gloss ? *gloss : object, gloss ? "diffuse" : "baseColor", has_vertex_colours);
  if (gloss) {
    reading.found.insert("specular-glossiness");
    reading.texture(*gloss, "specularGlossinessTexture", "specular-glossiness texture", true);
  }
  const bool is_metal = !gloss && reading.metallic_roughness(object);
  reading.texture(place, "normalTexture", "normal map", true);
  reading.texture(place, "occlusionTexture", "occlusion texture", true);
  const auto strength = extension(place, "KHR_materials_emissive_strength");
  if (reading.differs(place, "emissiveFactor", 0, 0) &&
      (!strength || reading.differs(*strength, "emissiveStrength", 0, 1))) {
    reading.found.insert("emission");
    reading.texture(place, "emissiveTexture", "emission texture", true);
  }
  for (const Lobe& lobe : lobes) reading.lobe(place, lobe);
  if (is_metal) return reading.found;
  for (const Lobe& lobe : lobes_of_dielectrics) reading.lobe(place, lobe);
  const bool is_passed =
      reading.found.contains("transmission") || reading.found.contains("diffuse transmission");
  if (is_passed && reading.lobe(place, volume)) reading.lobe(place, dispersion);
  return reading.found;
}

}  // namespace shadefit::scene
