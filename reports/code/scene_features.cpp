#include "reports/code/scene_features.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "fit/support/decimal.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

using scene::Features;
using scene::Material;

std::map<Features, std::vector<const Material*>> sets_of(const scene::Scene& scene) {
  std::map<Features, std::vector<const Material*>> sets;
  for (const Material& material : scene.materials) sets[material.features].push_back(&material);
  return sets;
}

Features all_of(const scene::Scene& scene) {
  Features all;
  for (const Material& material : scene.materials)
    all.insert(material.features.begin(), material.features.end());
  return all;
}

std::string listed(const Features& features) {
  return features.empty() ? "no feature" : fmt::format("{}", fmt::join(features, ", "));
}

}  // namespace

std::string features_text(const scene::Scene& scene) {
  const auto sets = sets_of(scene);
  const Features all = all_of(scene);
  std::string text =
      fmt::format("{}, {} of {}: {}\n", counted(std::ssize(scene.materials), "material"),
                  counted(std::ssize(sets), "set"), counted(std::ssize(all), "feature"), listed(all));
  for (const auto& [features, materials] : sets) {
    text += fmt::format("\n{}: {}\n", counted(std::ssize(materials), "material"), listed(features));
    for (const Material* material : materials)
      text += fmt::format("  {} ({})\n", printable(material->name), printable(material->file));
  }
  return text;
}

std::string features_json(const scene::Scene& scene) {
  using Json = nlohmann::ordered_json;
  Json sets = Json::array(), materials = Json::array();
  for (const auto& [features, members] : sets_of(scene))
    sets.push_back({{"features", features}, {"materials", members.size()}});
  for (const Material& m : scene.materials)
    materials.push_back({{"name", printable(m.name)}, {"file", printable(m.file)}, {"features", m.features}});
  return Json{{"schema", 1}, {"features", all_of(scene)}, {"sets", sets}, {"materials", materials}}.dump(2) +
         "\n";
}

}  // namespace shadefit
