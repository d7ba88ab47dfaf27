#include "scene/gltf/gltf_material.hpp"

#include <fmt/format.h>

#include <limits>

#include "approx/fresnel.hpp"
#include "scene/materials/conversions.hpp"
#include "scene/materials/messages.hpp"

namespace shadefit::scene {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A factor in [0, 1], 1 by default.
Range factor(const JsonPlace& object, std::string_view key) {
  const double number = number_or(object, key, 0, 1, 1);
  return {number, number};
}

/// A colour, white by default, that a texture may scale.
ColourRange colour(const JsonPlace& object, std::string_view key, std::size_t size, double most,
                   bool is_textured) {
  return scaled_colour(colour_or_white(object, key, size, most), is_textured);
}

/// Reads one material and records what is unknown.
struct MaterialReading {
  const GltfReading& gltf;
  Material& material;

  /// The ranges of a texture's channels.
  std::vector<Range> read(const JsonPlace& info, std::string_view what,
                          const std::vector<Channel>& channels) {
    const TextureReading& reading = gltf.images.read(info, channels);
    if (!reading.channels.empty()) return reading.channels;
    material.unknowns.push_back(fmt::format("{} {}", what, reading.unknown));
    return std::vector<Range>(channels.size(), unknown_texture);
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
  Range roughness = factor(object, "roughnessFactor"), metallic = factor(object, "metallicFactor");
  if (const auto info = member(object, "metallicRoughnessTexture")) {
    const auto channels = reading.read(*info, "metallic-roughness texture", {Channel::green, Channel::blue});
    roughness = roughness * channels[0];
    metallic = metallic * channels[1];
  }
  const auto power = [&](double value) { return power_of_roughness(value, reading.gltf.conventions); };
  take_powers(reading.material, roughness, power, PowerTexture::roughness);
  return metallic;
}

/// The values of KHR_materials_ior and KHR_materials_specular for a dielectric.
struct Dielectric {
  Range facing;  ///< its reflectance at normal incidence
  Range specular{1, 1};
  ColourRange colour = scaled_colour({1, 1, 1}, false);
};

double reflectance_of_ior(const JsonPlace& object) {
  const double ior = number_or(object, "ior", 0, endless, 1.5);
  if (ior > 0 && ior < 1)
    refuse(*member(object, "ior"), "it must be at least 1, or 0 for a reflectance of 1");
  return reflectance_at_normal(ior);
}

Dielectric read_dielectric(const JsonPlace& material, MaterialReading& reading) {
  Dielectric dielectric;
  const auto ior = extension(material, "KHR_materials_ior");
  const double facing = ior ? reflectance_of_ior(*ior) : reflectance_at_normal(1.5);
  dielectric.facing = {facing, facing};
  if (const auto object = extension(material, "KHR_materials_specular")) {
    const bool is_textured = member(*object, "specularTexture").has_value();
    const Range specular = factor(*object, "specularFactor");
    dielectric.specular = {is_textured ? 0 : specular.least, specular.most};
    const bool is_colour_textured = member(*object, "specularColorTexture").has_value();
    dielectric.colour = colour(*object, "specularColorFactor", 3, endless, is_colour_textured);
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
  const bool is_varied = metallic.most > 0 && (is_textured || has_vertex_colours);
  const ColourRange base = colour(object, "baseColorFactor", 4, 1, is_varied);
  if (metallic.most > 0) {
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
  Range gloss = factor(object, "glossinessFactor");
  const auto info = member(object, "specularGlossinessTexture");
  reading.material.f0 = colour(object, "specularFactor", 3, 1, info.has_value());
  if (info) {
    gloss = gloss * reading.read(*info, "specular-glossiness texture", {Channel::alpha}).front();
    reading.note_unread_colours("colour of the specular-glossiness texture is", "F0 is");
  }
  const auto power = [&](double value) { return power_of_gloss(value, reading.gltf.conventions); };
  take_powers(reading.material, gloss, power, PowerTexture::gloss);
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
    material.is_unlit = true;
    material.f90 = {0, 0};
    return material;
  }
  MaterialReading reading{gltf, material};
  if (const auto object = extension(place, "KHR_materials_pbrSpecularGlossiness")) {
    read_specular_glossiness(*object, reading);
  } else {
    read_metallic_workflow(place, has_vertex_colours, reading);
  }
  return material;
}

}  // namespace shadefit::scene
