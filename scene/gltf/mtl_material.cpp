#include "scene/gltf/mtl_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <system_error>

#include "approx/fresnel.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "scene/materials/conversions.hpp"
#include "scene/materials/messages.hpp"
#include "scene/materials/uri.hpp"

namespace shadefit::scene {
namespace {

/// The state of reading a material.
struct MtlReading {
  const MtlEntry& entry;
  MtlMapReader& reader;
  const Conventions& conventions;
  Material material;
  Range metallic = {};

  Range read(const ScalarMap& map, std::string_view what) {
    return reader.read(map, what, material.unknowns);
  }

  /// A map, or by the conventions another; null without both.
  const ScalarMap* first_of(const ScalarMap& map, const ScalarMap& by_conventions) const {
    if (!map.name.empty()) return &map;
    return conventions.are_maps_pbr && !by_conventions.name.empty() ? &by_conventions : nullptr;
  }
  /// map_Pr, or map_Ns by the conventions.
  const ScalarMap* roughness_map() const { return first_of(entry.roughness_map, entry.shininess_map); }
  /// map_Pm, or map_Ka by the conventions.
  const ScalarMap* metallic_map() const { return first_of(entry.metallic_map, entry.ambient_map); }
};

/// Ns, times map_Ns if there is one.
void read_shininess(MtlReading& reading) {
  Material& material = reading.material;
  if (!reading.entry.shininess) material.remarks.push_back("Ns is missing and is taken for 1");
  const double number = reading.entry.shininess.value_or(1);
  Range shininess{number, number};
  const bool is_scaled = !reading.conventions.are_maps_pbr && !reading.entry.shininess_map.name.empty();
  if (is_scaled) shininess = shininess * reading.read(reading.entry.shininess_map, "shininess texture");
  take_powers(material, shininess, std::identity(), PowerTexture::power, "Ns");
}

/// Ks as a factor, without a Fresnel term.
void read_phong(MtlReading& reading) {
  Material& material = reading.material;
  material.fresnel = FresnelTerm::none;
  const bool is_specular = reading.entry.illumination.value_or(2) > 1;
  const bool is_textured = reading.entry.has_specular_map;
  const double unsaid = is_textured ? 1 : 0;  // a map without Ks is the colour itself
  auto colour = reading.entry.specular.value_or(std::array{unsaid, unsaid, unsaid});
  const bool is_black =
      std::all_of(colour.begin(), colour.end(), [](double channel) { return channel == 0; });
  if (!is_specular || is_black) {
    const double shininess = reading.entry.shininess.value_or(0);
    take_powers(material, {shininess, shininess}, std::identity(), PowerTexture::none, "Ns");
    return;
  }
  if (*std::max_element(colour.begin(), colour.end()) > most_factor) {
    material.remarks.push_back(fmt::format("Ks above {} is taken for that", most_factor));
    for (double& channel : colour) channel = std::min(channel, most_factor);
  }
  material.f0 = scaled_colour(colour, is_textured);
  material.has_unread_colours = is_textured;
  if (is_textured)
    material.unknowns.push_back("specular texture is not read: Ks is taken from 0 to its value");
  read_shininess(reading);
}

void read_roughness(MtlReading& reading) {
  Material& material = reading.material;
  const ScalarMap* const map = reading.roughness_map();
  const double factor = reading.entry.roughness.value_or(1);
  Range roughness{factor, factor};
  PowerTexture texture = PowerTexture::none;
  if (map != nullptr) {
    roughness = roughness * reading.read(*map, "roughness texture");
    texture = PowerTexture::roughness;
  } else if (!reading.entry.roughness) {
    if (reading.entry.shininess) return read_shininess(reading);
    material.unknowns.push_back("roughness is missing");
    roughness = unknown_texture;
  }
  const auto power = [&](double value) { return power_of_roughness(value, reading.conventions); };
  take_powers(material, roughness, power, texture);
}

Range read_metallic(MtlReading& reading) {
  const ScalarMap* const map = reading.metallic_map();
  const double metallic = reading.entry.metallic.value_or(map != nullptr ? 1 : 0);
  const Range range{metallic, metallic};
  return map == nullptr ? range : range * reading.read(*map, "metallic texture");
}

/// The metallic workflow, with Kd as its base colour.
void read_metallic_roughness(MtlReading& reading) {
  Material& material = reading.material;
  read_roughness(reading);
  const Range metallic = reading.metallic = read_metallic(reading);
  auto base = reading.entry.diffuse.value_or(std::array{1.0, 1.0, 1.0});
  if (*std::max_element(base.begin(), base.end()) > 1) {
    material.remarks.push_back("Kd above 1 is taken for 1");
    for (double& channel : base) channel = std::min(channel, 1.0);
  }
  const double ior = reading.entry.index_of_refraction.value_or(1.5);
  const double dielectric = reflectance_at_normal(ior);
  const ColourRange colours = scaled_colour(base, reading.entry.has_diffuse_map);
  material.has_unread_colours = reading.entry.has_diffuse_map && metallic.most > 0;
  if (material.has_unread_colours)
    material.unknowns.push_back("base colour texture is not read: F0 of metal is taken from 0 to Kd");
  for (std::size_t i = 0; i < colours.size(); ++i)
    material.f0[i] = metallic_range({dielectric, dielectric}, colours[i], metallic);
}

/// What a shader needs for the material that was read, by value. Only maps of roughness, shininess and
/// metallic are known by their texels; other maps count where their factor is not 0.
Features features_of(const MtlReading& reading) {
  const MtlEntry& entry = reading.entry;
  const Material& material = reading.material;
  constexpr std::array<double, 3> black{};
  const bool is_phong = material.fresnel == FresnelTerm::none;
  const bool is_specular = is_phong && material.f0 != ColourRange{};
  const bool emits = entry.emission ? *entry.emission != black : entry.has_emission_map;
  const std::pair<const char*, bool> features[]{
      {"base colour texture", entry.has_diffuse_map && entry.diffuse != black},
      {"roughness texture", material.power_texture == PowerTexture::roughness},
      {"shininess texture", material.power_texture == PowerTexture::power},
      {"metallic texture", !reading.metallic.is_constant()},
      {"specular", is_specular},
      {"specular texture", is_specular && entry.has_specular_map},
      {"ior", !is_phong && reading.metallic.least < 1 && entry.index_of_refraction.value_or(1.5) != 1.5},
      {"normal map", entry.has_normal_map},
      {"emission", emits},
      {"emission texture", emits && entry.has_emission_map},
      {"alpha blend", entry.opacity < 1 || entry.has_opacity_map},
      {"clear coat", entry.left_out.contains("Pc")},
      {"sheen", entry.left_out.contains("Ps")},
      {"anisotropy", entry.left_out.contains("aniso")}};
  Features found;
  for (const auto& [feature, is_needed] : features) {
    if (is_needed) found.insert(feature);
  }
  return found;
}

}  // namespace

Range MtlMapReader::read(const ScalarMap& map, std::string_view what, std::vector<std::string>& unknowns) {
  const std::filesystem::path path = path_within(folder_, map.name);
  std::error_code ignored;
  const auto unknown = [&](std::string_view reason) {
    unknowns.push_back(fmt::format("{} '{}' {}", what, shortened(map.name), reason));
    return unknown_texture;
  };
  const std::pair key{path.string(), map.channel};
  const auto known = read_.find(key);
  if (known != read_.end()) return known->second;
  if (!std::filesystem::exists(path, ignored)) return unknown("is missing");
  const std::string encoded = read_bounded(path, most_picture_bytes);
  if (picture_format(encoded) == PictureFormat::other) return unknown("is neither PNG nor JPEG");
  const std::vector<Range> ranges = at_place(fmt::format("'{}'", path.string()), [&] {
    return pictures_.ranges(encoded, {&map.channel, 1});
  });
  return read_.emplace(key, ranges.front()).first->second;
}

Material mtl_material(const MtlEntry& entry, const std::string& file, MtlMapReader& reader,
                      const Conventions& conventions) {
  MtlReading reading{entry, reader, conventions, {}};
  reading.material.name = entry.name;
  reading.material.file = file;
  const std::string place = fmt::format("'{}', material '{}' of line {}", file, entry.name, entry.line);
  at_place(place, [&] {
    const bool is_metallic_roughness = entry.roughness || entry.metallic ||
                                       reading.roughness_map() != nullptr ||
                                       reading.metallic_map() != nullptr;
    if (is_metallic_roughness) {
      read_metallic_roughness(reading);
    } else {
      read_phong(reading);
    }
  });
  if (conventions.has_features) reading.material.features = features_of(reading);
  for (const std::string& key : entry.left_out) reading.material.remarks.push_back(key + " is left out");
  return std::move(reading.material);
}

}  // namespace shadefit::scene
