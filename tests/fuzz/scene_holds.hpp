#pragma once

#include <cmath>
#include <cstdlib>

#include "scene/materials/material.hpp"

/// What has to be true of every scene that a reader returns; a fuzzer ends where it is not.
namespace shadefit::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline void require_range(const scene::Range& range) {
  require(range.least >= 0 && range.least <= range.most && std::isfinite(range.most));
}

inline void require_holds(const scene::Scene& scene) {
  require(scene.lights >= 0);
  for (const scene::Material& material : scene.materials) {
    for (const scene::Range& channel : material.f0) require_range(channel);
    require_range(material.f90);
    require_range(material.power);
    require(material.power.most <= scene::most_power);
  }
}

}  // namespace shadefit::fuzz
