#pragma once

#include <string>

#include "reports/io/table.hpp"
#include "reports/io/writers.hpp"
#include "scene/plan/plan.hpp"

/// The plan of a scene as text, Markdown, CSV and JSON.
namespace shadefit {

/// `term,verdict,form,error,reason`, a row for each term: `scene.csv`.
Table decisions_table(const scene::Plan& plan);

/// The plan on a terminal.
std::string plan_text(const scene::Scene& scene, const scene::Plan& plan, const Terminal& terminal = {});

/// The same as Markdown, with every material: `scene.md`.
std::string plan_markdown(const scene::Scene& scene, const scene::Plan& plan);

/// The same as JSON: `scene.json`.
std::string plan_json(const scene::Scene& scene, const scene::Plan& plan);

}  // namespace shadefit
