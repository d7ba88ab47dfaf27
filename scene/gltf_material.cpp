#include "scene/gltf_material.hpp"

#include <fmt/format.h>

#include <limits>

#include "scene/powers.hpp"
#include "scene/reflectances.hpp"

namespace shadefit::scene {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// An extension of a material that has it.
std::optional<JsonPlace> extension(const JsonPlace& material, std::string_view name) {
  const auto extensions = member(material, "extensions");
  return extensions ? member(*extensions, name) : std::nullopt;
}

/// Where textures are read for one material, and what they leave unknown is noted.
struct TextureNotes {
  GltfImages& images;
  Material& material;

  /// The histograms of a texture; every code alike where it is not known.
  std::vector<Histogram> read(const JsonPlace& info, std::string_view what,
                              const std::vector<Channel>& channels) {
    const TextureReading& reading = images.read(info, channels);
    if (!reading.channels.empty()) return reading.channels;
    material.unknowns.push_back(fmt::format("{} {}", what, reading.unknown));
    return std::vector<Histogram>(channels.size(), unknown_texture());
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

/// Roughness and metallic: the powers of the material, and the range of what is metallic.
Range read_metallic_roughness(const JsonPlace& object, TextureNotes& textures,
                              const Conventions& conventions) {
  const double roughness = number_or(object, "roughnessFactor", 0, 1, 1);
  const double metallic = number_or(object, "metallicFactor", 0, 1, 1);
  const PowerOf power = [&](double value) { return power_of_roughness(value, conventions); };
  const auto info = member(object, "metallicRoughnessTexture");
  if (!info) {
    textures.material.powers = {{power(roughness), 1}};
    return {metallic, metallic};
  }
  const auto channels = textures.read(*info, "metallic-roughness texture", {Channel::green, Channel::blue});
  take_powers(textures.material, power_shares(channels[0], roughness, power), PowerTexture::roughness);
  return range_of_texture(channels[1], metallic);
}

/// What KHR_materials_ior and KHR_materials_specular say of a dielectric.
struct Dielectric {
  double ior = 1.5;
  Range specular{1, 1};
  ColourRange colour = scaled_colour({1, 1, 1}, false);
};

Dielectric read_dielectric(const JsonPlace& material, TextureNotes& textures) {
  Dielectric dielectric;
  if (const auto object = extension(material, "KHR_materials_ior")) {
    dielectric.ior = number_or(*object, "ior", 0, endless, dielectric.ior);
    if (dielectric.ior > 0 && dielectric.ior < 1)
      refuse(*member(*object, "ior"), "it must be at least 1, or 0 for a reflectance of 1");
  }
  if (const auto object = extension(material, "KHR_materials_specular")) {
    const bool is_textured = member(*object, "specularTexture").has_value();
    const double specular = number_or(*object, "specularFactor", 0, 1, 1);
    dielectric.specular = {is_textured ? 0 : specular, specular};
    const bool is_colour_textured = member(*object, "specularColorTexture").has_value();
    dielectric.colour =
        scaled_colour(colour_or_white(*object, "specularColorFactor", 3, endless), is_colour_textured);
    if (is_textured) textures.note_unread("specular texture is", "F0 and F90 of dielectrics are");
    if (is_colour_textured)
      textures.note_unread_colours("specular colour texture is", "F0 of dielectrics is");
  }
  return dielectric;
}

/// F0 and F90 by metallic-roughness.
void read_metallic_workflow(const JsonPlace& place, bool has_vertex_colours, TextureNotes& textures,
                            const Conventions& conventions) {
  Material& material = textures.material;
  const nlohmann::json nothing = nlohmann::json::object();
  const auto object =
      member(place, "pbrMetallicRoughness").value_or(JsonPlace{&nothing, place.pointer, place.file});
  const Range metallic = read_metallic_roughness(object, textures, conventions);
  const bool is_textured = member(object, "baseColorTexture").has_value();
  const ColourRange base =
      scaled_colour(colour_or_white(object, "baseColorFactor", 4, 1), is_textured || has_vertex_colours);
  if (is_textured && metallic.most > 0)
    textures.note_unread_colours("base colour texture is", "F0 of metal is");
  if (has_vertex_colours && metallic.most > 0)
    textures.note_unread_colours("colours of vertices are", "F0 of metal is");
  const Dielectric dielectric = read_dielectric(place, textures);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Range f0 = dielectric_range(dielectric.ior, dielectric.colour[i], dielectric.specular);
    material.f0[i] = metallic_range(f0, base[i], metallic);
  }
  material.f90 = metallic_range(dielectric.specular, {1, 1}, metallic);
}

/// F0 and powers by KHR_materials_pbrSpecularGlossiness.
void read_specular_glossiness(const JsonPlace& object, TextureNotes& textures,
                              const Conventions& conventions) {
  Material& material = textures.material;
  const double gloss = number_or(object, "glossinessFactor", 0, 1, 1);
  const PowerOf power = [&](double value) { return power_of_gloss(value, conventions); };
  const auto info = member(object, "specularGlossinessTexture");
  material.f0 = scaled_colour(colour_or_white(object, "specularFactor", 3, 1), info.has_value());
  if (!info) {
    material.powers = {{power(gloss), 1}};
    return;
  }
  const auto channels = textures.read(*info, "specular-glossiness texture", {Channel::alpha});
  take_powers(material, power_shares(channels[0], gloss, power), PowerTexture::gloss);
  textures.note_unread_colours("colour of the specular-glossiness texture is", "F0 is");
}

void note_other_lobes(const JsonPlace& place, Material& material) {
  for (const std::string_view name : {"KHR_materials_anisotropy", "KHR_materials_clearcoat",
                                      "KHR_materials_iridescence", "KHR_materials_sheen"}) {
    if (extension(place, name)) material.remarks.push_back(fmt::format("{} is left out", name));
  }
}

/// Nothing is shaded: no reflectance, and one power that says nothing.
void make_unlit(Material& material) {
  material.is_unlit = true;
  material.f0 = {};
  material.f90 = {0, 0};
  material.powers = {{0, 1}};
}

}  // namespace

Material read_gltf_material(const JsonPlace& place, std::size_t index, bool has_vertex_colours,
                            GltfImages& images, const Conventions& conventions) {
  Material material;
  material.file = place.file;
  const auto name = member(place, "name");
  material.name = name ? std::string(text_at(*name)) : fmt::format("material {}", index);
  if (extension(place, "KHR_materials_unlit")) {
    make_unlit(material);
    return material;
  }
  TextureNotes textures{images, material};
  if (const auto object = extension(place, "KHR_materials_pbrSpecularGlossiness")) {
    read_specular_glossiness(*object, textures, conventions);
  } else {
    read_metallic_workflow(place, has_vertex_colours, textures, conventions);
  }
  note_other_lobes(place, material);
  limit_powers(material, "the specular power");
  return material;
}

Material default_gltf_material(const std::string& file, bool has_vertex_colours,
                               const Conventions& conventions) {
  const nlohmann::json nothing = nlohmann::json::object();
  const JsonPlace place{&nothing, "", file};
  GltfImages images(place, std::nullopt, file);
  Material material = read_gltf_material(place, 0, has_vertex_colours, images, conventions);
  material.name = "default";
  return material;
}

}  // namespace shadefit::scene
