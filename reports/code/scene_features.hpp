#pragma once

#include <string>

#include "scene/materials/material.hpp"

/// The features that the materials of scenes need, for who builds only the shader variants that occur.
namespace shadefit {

/// Each set of features that occurs, with the materials that have it.
std::string features_text(const scene::Scene& scene);

/// The same as JSON: `features` that occur in any material, `sets` of them with the number of materials, and
/// `materials` with the features of each.
std::string features_json(const scene::Scene& scene);

}  // namespace shadefit
