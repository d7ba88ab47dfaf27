#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/materials/material.hpp"

/// Small scenes that are shaded in tests.
namespace shadefit::testing {

inline scene::Material one_material(double reflectance, std::vector<scene::PowerShare> powers) {
  scene::Material made;
  made.name = "some";
  made.f0.fill({reflectance, reflectance});
  made.powers = std::move(powers);
  return made;
}

inline scene::Scene scene_of(std::vector<scene::Material> materials) {
  scene::Scene made;
  made.materials = std::move(materials);
  return made;
}

/// One for each path that a plan takes, by its name.
inline std::map<std::string, scene::Scene> shaded_scenes() {
  using scene::FresnelTerm;
  using scene::Scene;
  std::map<std::string, Scene> scenes;
  scenes["one whole power"] = scene_of({one_material(0.04, {{16, 1}})});
  scenes["one power"] = scene_of({one_material(0.04, {{33.3, 1}})});
  scenes["several powers"] =
      scene_of({one_material(0.04, {{10, 1}}), one_material(0.3, {{80, 1}}), one_material(0.02, {{2.5, 1}})});
  scenes["constant"] = scene_of({one_material(0.9, {{0, 1}})});
  Scene textured = scene_of({one_material(0.04, {{1, 0.25}, {20, 0.5}, {1000, 0.25}})});
  textured.materials.front().power_texture = scene::PowerTexture::roughness;
  scenes["textured"] = textured;
  textured.materials.push_back(one_material(0.6, {{50, 1}}));
  scenes["one of two is textured"] = textured;
  Scene coloured = scene_of({one_material(0.5, {{40, 1}})});
  coloured.materials.front().f0[2] = {0.1, 0.1};
  scenes["coloured"] = coloured;
  Scene factor = scene_of({one_material(0.5, {{40, 1}})});
  factor.materials.front().fresnel = FresnelTerm::none;
  scenes["without Fresnel"] = factor;
  Scene black = factor;
  black.materials.push_back(one_material(0, {{20, 1}}));
  black.materials.back().fresnel = FresnelTerm::none;
  scenes["one of two is black"] = black;
  black.materials.front().is_unlit = true;
  scenes["nothing to see"] = black;
  return scenes;
}

}  // namespace shadefit::testing
