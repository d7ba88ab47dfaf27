#pragma once

#include <string>

#include "reports/io/table.hpp"
#include "reports/io/writers.hpp"
#include "scene/plan/plan.hpp"

/// What the materials of a scene need: its features, and its plan as text, Markdown, CSV and JSON.
namespace shadefit {

/// `term,verdict,form,error,reason`, a row for each term: `scene.csv`.
Table decisions_table(const scene::Plan& plan);

/// The plan on a terminal.
std::string plan_text(const scene::Scene& scene, const scene::Plan& plan, const Terminal& terminal = {});

/// The same as Markdown, with every material: `scene.md`.
std::string plan_markdown(const scene::Scene& scene, const scene::Plan& plan);

/// The same as JSON: `scene.json`.
std::string plan_json(const scene::Scene& scene, const scene::Plan& plan);

/// The features that the materials of a scene need, for who builds only the shader variants that occur: each
/// set of them, with the materials that have it.
std::string features_text(const scene::Scene& scene);

/// The same as JSON: `features` that occur in any material, `sets` of them with the number of materials, and
/// `materials` with the features of each.
std::string features_json(const scene::Scene& scene);

}  // namespace shadefit
