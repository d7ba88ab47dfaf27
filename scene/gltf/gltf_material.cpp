#include "scene/gltf/gltf_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "approx/fresnel.hpp"
#include "scene/files/messages.hpp"
#include "scene/gltf/gltf_extensions.hpp"
#include "scene/materials/powers.hpp"
#include "scene/materials/reflectances.hpp"

namespace shadefit::scene {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// The upper limit of an animated factor that has no limit of its own.
constexpr double unlimited = std::numeric_limits<double>::max();

/// Reads one material and records what is unknown.
struct MaterialReading {
  const GltfReading& gltf;
  Material& material;

  /// Whether the member `key` of an object is animated. If so, this is recorded with the range.
  bool is_animated(const JsonPlace& object, std::string_view key, std::string_view range) {
    if (!gltf.animated.contains(fmt::format("{}/{}", object.pointer, key))) return false;
    material.unknowns.push_back(fmt::format("{} is animated: it is taken from {}", key, range));
    return true;
  }

  /// A factor in [0, 1], 1 by default: one number, or the whole range if it is animated.
  Range factor(const JsonPlace& object, std::string_view key) {
    const double number = number_or(object, key, 0, 1, 1);
    return is_animated(object, key, "0 to 1") ? Range{0, 1} : Range{number, number};
  }

  /// A colour, white by default, that a texture or an animation may scale.
  ColourRange colour(const JsonPlace& object, std::string_view key, std::size_t size, double most,
                     bool is_textured) {
    const auto numbers = colour_or_white(object, key, size, most);
    if (!is_animated(object, key, most == 1 ? "0 to 1" : "0 on")) return scaled_colour(numbers, is_textured);
    material.has_unread_colours = true;
    const double largest = std::min(most, unlimited);
    return scaled_colour({largest, largest, largest}, true);
  }

  /// The histograms of a texture; uniform if the texture is unknown.
  std::vector<Histogram> read(const JsonPlace& info, std::string_view what,
                              const std::vector<Channel>& channels) {
    const TextureReading& reading = gltf.images.read(info, channels);
    if (!reading.channels.empty()) return reading.channels;
    material.unknowns.push_back(fmt::format("{} {}", what, reading.unknown));
    return std::vector<Histogram>(channels.size(), unknown_texture());
  }

  /// Sets the powers from a factor times the texels of its texture, if there is one.
  void take_powers_of(const Range& factor, const std::optional<Histogram>& texels, const PowerOf& power,
                      PowerTexture texture) {
    if (texels || !factor.is_constant()) {
      const Histogram& used = factor.is_constant() ? *texels : unknown_texture();
      take_powers(material, power_shares(used, factor.most, power), texture);
    } else {
      material.powers = {{power(factor.most), 1}};
    }
  }

  void note_unread_colours(std::string_view texture, std::string_view reflectances) {
    material.has_unread_colours = true;
    note_unread(texture, reflectances);
  }
  void note_unread(std::string_view texture, std::string_view reflectances) {
    material.unknowns.push_back(
        fmt::format("{} not read: {} taken from 0 to the factor", texture, reflectances));
  }
};

/// Roughness and metallic: sets the powers of the material and returns the range of metallic.
Range read_metallic_roughness(const JsonPlace& object, MaterialReading& reading) {
  const Range roughness = reading.factor(object, "roughnessFactor");
  const Range metallic = reading.factor(object, "metallicFactor");
  const PowerOf power = [&](double value) { return power_of_roughness(value, reading.gltf.conventions); };
  const auto info = member(object, "metallicRoughnessTexture");
  if (!info) {
    reading.take_powers_of(roughness, std::nullopt, power, PowerTexture::roughness);
    return metallic;
  }
  const auto channels = reading.read(*info, "metallic-roughness texture", {Channel::green, Channel::blue});
  reading.take_powers_of(roughness, channels[0], power, PowerTexture::roughness);
  return {range_of_texture(channels[1], metallic.least).least,
          range_of_texture(channels[1], metallic.most).most};
}

/// The values of KHR_materials_ior and KHR_materials_specular for a dielectric.
struct Dielectric {
  Range facing;  ///< its reflectance at normal incidence
  Range specular{1, 1};
  ColourRange colour = scaled_colour({1, 1, 1}, false);
};

Range reflectance_of_ior(const JsonPlace& object, MaterialReading& reading) {
  const double ior = number_or(object, "ior", 0, endless, 1.5);
  if (ior > 0 && ior < 1)
    refuse(*member(object, "ior"), "it must be at least 1, or 0 for a reflectance of 1");
  if (reading.is_animated(object, "ior", "1 on")) return {0, 1};
  const double reflectance = reflectance_at_normal(ior);
  return {reflectance, reflectance};
}

Dielectric read_dielectric(const JsonPlace& material, MaterialReading& reading) {
  Dielectric dielectric;
  const double glass = reflectance_at_normal(1.5);
  dielectric.facing = {glass, glass};
  if (const auto object = extension(material, "KHR_materials_ior"))
    dielectric.facing = reflectance_of_ior(*object, reading);
  if (const auto object = extension(material, "KHR_materials_specular")) {
    const bool is_textured = member(*object, "specularTexture").has_value();
    const Range specular = reading.factor(*object, "specularFactor");
    dielectric.specular = {is_textured ? 0 : specular.least, specular.most};
    const bool is_colour_textured = member(*object, "specularColorTexture").has_value();
    dielectric.colour = reading.colour(*object, "specularColorFactor", 3, endless, is_colour_textured);
    if (is_textured) reading.note_unread("specular texture is", "F0 and F90 of dielectrics are");
    if (is_colour_textured) reading.note_unread_colours("specular colour texture is", "F0 of dielectrics is");
  }
  return dielectric;
}

/// F0 and F90 by metallic-roughness.
void read_metallic_workflow(const JsonPlace& place, bool has_vertex_colours, MaterialReading& reading) {
  Material& material = reading.material;
  const JsonPlace object = member_or_empty(place, "pbrMetallicRoughness");
  const Range metallic = read_metallic_roughness(object, reading);
  const bool is_textured = member(object, "baseColorTexture").has_value();
  ColourRange base = scaled_colour(colour_or_white(object, "baseColorFactor", 4, 1), false);
  if (metallic.most > 0) {
    base = reading.colour(object, "baseColorFactor", 4, 1, is_textured || has_vertex_colours);
    if (is_textured) reading.note_unread_colours("base colour texture is", "F0 of metal is");
    if (has_vertex_colours) reading.note_unread_colours("colours of vertices are", "F0 of metal is");
  }
  const Dielectric dielectric = read_dielectric(place, reading);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Range f0 = dielectric_range(dielectric.facing, dielectric.colour[i], dielectric.specular);
    material.f0[i] = metallic_range(f0, base[i], metallic);
  }
  material.f90 = metallic_range(dielectric.specular, {1, 1}, metallic);
}

/// F0 and powers by KHR_materials_pbrSpecularGlossiness.
void read_specular_glossiness(const JsonPlace& object, MaterialReading& reading) {
  const Range gloss = reading.factor(object, "glossinessFactor");
  const PowerOf power = [&](double value) { return power_of_gloss(value, reading.gltf.conventions); };
  const auto info = member(object, "specularGlossinessTexture");
  reading.material.f0 = reading.colour(object, "specularFactor", 3, 1, info.has_value());
  if (!info) {
    reading.take_powers_of(gloss, std::nullopt, power, PowerTexture::gloss);
    return;
  }
  const auto channels = reading.read(*info, "specular-glossiness texture", {Channel::alpha});
  reading.take_powers_of(gloss, channels[0], power, PowerTexture::gloss);
  reading.note_unread_colours("colour of the specular-glossiness texture is", "F0 is");
}

/// Records what the plan leaves out: other lobes, transmission, unknown extensions.
void note_left_out(const JsonPlace& place, Material& material) {
  const auto extensions = member(place, "extensions");
  if (!extensions) return;
  for (const auto& [name, ignored] : extensions->value->items()) {
    if (is_left_out(name)) material.remarks.push_back(fmt::format("{} is left out", shortened(name)));
  }
}

/// Makes a material unshaded: no reflectance, and one power without a meaning.
void make_unlit(Material& material) {
  material.is_unlit = true;
  material.f0 = {};
  material.f90 = {0, 0};
  material.powers = {{0, 1}};
}

}  // namespace

Material read_gltf_material(const JsonPlace& place, std::size_t index, bool has_vertex_colours,
                            const GltfReading& gltf) {
  Material material;
  material.file = place.file;
  const auto name = member(place, "name");
  material.name = name ? shortened(text_at(*name)) : fmt::format("material {}", index);
  if (gltf.conventions.has_features) material.features = read_gltf_features(place, has_vertex_colours, gltf);
  if (extension(place, "KHR_materials_unlit")) {
    make_unlit(material);
    return material;
  }
  MaterialReading reading{gltf, material};
  if (const auto object = extension(place, "KHR_materials_pbrSpecularGlossiness")) {
    read_specular_glossiness(*object, reading);
  } else {
    read_metallic_workflow(place, has_vertex_colours, reading);
  }
  note_left_out(place, material);
  limit_powers(material, "the specular power");
  return material;
}

}  // namespace shadefit::scene
