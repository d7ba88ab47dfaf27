#include "reports/code/scene_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "fit/support/decimal.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

using scene::Features;
using scene::Material;
using scene::MaterialPlan;
using scene::Plan;
using scene::Scene;
using Json = nlohmann::ordered_json;

/// A bound with few digits for readers.
Cell bound(double value) {
  return Number{value, 3};
}

std::string range_text(const scene::Range& range) {
  return range.is_constant() ? decimal(range.least, 4)
                             : decimal(range.least, 4) + " to " + decimal(range.most, 4);
}

std::string headline(const Scene& scene, const Plan& plan) {
  return fmt::format("{}, {}, tolerance {} in {}",
                     counted(static_cast<long>(scene.materials.size()), "material"),
                     counted(plan.wanted.lights, "light"), decimal(plan.wanted.tolerance, 4),
                     plan.wanted.scale == scene::ShownScale::linear ? "linear values" : "sRGB codes");
}

std::string summary(const Plan& plan) {
  const int lights = plan.wanted.lights;
  return fmt::format("Error at most {} of {}{}: {}.\n", decimal_above(plan.error, 3),
                     decimal(plan.wanted.tolerance, 4),
                     lights == 1 ? "" : fmt::format(" ({} lights, each by the rows above)", lights),
                     plan.is_within() ? "within the tolerance" : "NOT within the tolerance");
}

/// What is unknown, what was changed, and what the plan does not cover, one line each.
std::vector<std::string> notes(const Scene& scene, const Plan& plan) {
  std::vector<std::string> lines = plan.notes;
  for (const std::string& remark : scene.remarks) lines.push_back(printable(remark));
  for (const std::string& name : scene.unused)
    lines.push_back(fmt::format("'{}': nothing is drawn with it, and it is not counted", printable(name)));
  for (const Material& material : scene.materials) {
    for (const auto* some : {&material.unknowns, &material.remarks}) {
      for (const std::string& line : *some)
        lines.push_back(fmt::format("'{}': {}", printable(material.name), printable(line)));
    }
  }
  return lines;
}

Json json_of(const scene::Range& range) {
  return Json::array({range.least, range.most});
}

/// `material,lobe,power,largest,reason`, a row for each material.
Table materials_table(const Scene& scene, const Plan& plan) {
  Table table{.columns = {"material", "lobe", "power", "largest", "reason"}};
  for (std::size_t i = 0; i < plan.materials.size(); ++i) {
    const MaterialPlan& m = plan.materials[i];
    const Material& material = scene.materials[i];
    const bool is_textured = material.is_power_textured();
    table.rows.push_back({OthersText(material.name), std::string(m.has_lobe ? "yes" : "no"),
                          range_text(m.power) + (is_textured ? ", textured" : ""), bound(m.factor),
                          OthersText(m.reason)});
  }
  return table;
}

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

Table decisions_table(const Plan& plan) {
  Table table{.columns = {"term", "verdict", "form", "error", "reason"}};
  for (const scene::Decision& d : plan.decisions)
    table.rows.push_back({d.term, word(name(d.treatment)), d.form, bound(d.error), d.reason});
  return table;
}

std::string plan_text(const Scene& scene, const Plan& plan, const Terminal& terminal) {
  std::string text = headline(scene, plan) + "\n\n" +
                     write_console(decisions_table(plan), Precision::report, terminal) + "\n" + summary(plan);
  for (const std::string& line : notes(scene, plan)) text += "Note: " + line + "\n";
  return text;
}

std::string plan_markdown(const Scene& scene, const Plan& plan) {
  std::string text =
      "# What this scene needs\n\n" + headline(scene, plan) + ".\n\n" +
      markdown_block(decisions_table(plan)) + summary(plan) +
      "\n`error` is that of one light's result F (n + 2)/8 c^n (n.l), clamped to [0, 1], at most: proven. "
      "Where a normal map turns a normal away from the viewer, n.v < 0, n.l counts as 2 n.h at most.\n\n# Materials\n\n`largest` is the "
      "largest F (n + 2)/8.\n\n" +
      markdown_block(materials_table(scene, plan));
  const std::vector<std::string> lines = notes(scene, plan);
  if (!lines.empty()) text += "# Notes\n\n";
  for (const std::string& line : lines) text += "- " + for_markdown(line) + "\n";
  return text;
}

std::string plan_json(const Scene& scene, const Plan& plan) {
  Json materials = Json::array();
  for (std::size_t i = 0; i < plan.materials.size(); ++i) {
    const MaterialPlan& m = plan.materials[i];
    const Material& material = scene.materials[i];
    materials.push_back({{"name", printable(material.name)},
                         {"lobe", m.has_lobe},
                         {"reason", m.reason},
                         {"largest", m.factor},
                         {"f0", {json_of(material.f0[0]), json_of(material.f0[1]), json_of(material.f0[2])}},
                         {"f90", json_of(material.f90)},
                         {"power", json_of(m.power)},
                         {"textured", material.is_power_textured()}});
  }
  Json unused = Json::array();
  for (const std::string& name : scene.unused) unused.push_back(printable(name));
  return Json{{"schema", 1},
              {"tolerance", plan.wanted.tolerance},
              {"scale", plan.wanted.scale == scene::ShownScale::linear ? "linear" : "codes"},
              {"precision", name(plan.wanted.precision)},
              {"lights", plan.wanted.lights},
              {"error", plan.error},
              {"terms", write_json(decisions_table(plan))},
              {"materials", materials},
              {"unused", unused},
              {"notes", notes(scene, plan)}}
             .dump(2) +
         "\n";
}

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
  Json sets = Json::array(), materials = Json::array();
  for (const auto& [features, members] : sets_of(scene))
    sets.push_back({{"features", features}, {"materials", members.size()}});
  for (const Material& m : scene.materials)
    materials.push_back({{"name", printable(m.name)}, {"file", printable(m.file)}, {"features", m.features}});
  return Json{{"schema", 1}, {"features", all_of(scene)}, {"sets", sets}, {"materials", materials}}.dump(2) +
         "\n";
}

}  // namespace shadefit
