#include "bench/shading/shaded_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "approx/gloss.hpp"

namespace shadefit::shade {
namespace {

/// The largest float that is not above `value`.
float rounded_down(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) <= value ? nearest
                                               : std::nextafter(nearest, -std::numeric_limits<float>::max());
}

}  // namespace

FullMaterial<double> full_material(const scene::Material& material) {
  FullMaterial<double> full{};
  for (std::size_t i = 0; i < full.f0.size(); ++i) {
    full.f0[i] = material.f0[i].most;
    full.f90[i] = material.fresnel == scene::FresnelTerm::none ? full.f0[i] : material.f90.most;
    if (material.is_unlit) full.f0[i] = full.f90[i] = 0;
  }
  full.power = material.powers.front().power;
  return full;
}

FullMaterial<float> narrowed(const FullMaterial<double>& material) {
  FullMaterial<float> narrow{};
  for (std::size_t i = 0; i < narrow.f0.size(); ++i) {
    narrow.f0[i] = static_cast<float>(material.f0[i]);
    narrow.f90[i] = static_cast<float>(material.f90[i]);
  }
  narrow.power = static_cast<float>(material.power);
  return narrow;
}

std::optional<PlannedMaterial> planned_material(const scene::Material& material,
                                                const scene::MaterialPlan& of_material,
                                                const scene::PlannedShading& shading) {
  if (!of_material.has_lobe) return std::nullopt;
  const FullMaterial<double> full = full_material(material);
  const scene::LobeForm& lobe = shading.lobe;
  PlannedMaterial planned;
  planned.kind = lobe.kind;
  planned.is_fused = lobe.is_fused;
  planned.whole = lobe.whole;
  planned.exp2_degree = shading.exp2_degree;
  planned.is_power_of_pixel = shading.is_power_of_pixel && material.is_power_textured();
  planned.has_fresnel = shading.has_fresnel;
  planned.is_coloured = shading.is_coloured;
  planned.slope_count = static_cast<int>(lobe.slopes.size());
  const double sharpness = planned.is_power_of_pixel ? 1 : full.power + lobe.offset;
  for (std::size_t i = 0; i < lobe.slopes.size(); ++i)
    planned.slopes.at(i) = static_cast<float>(sharpness * lobe.slopes[i]);
  planned.offset = static_cast<float>(lobe.offset);
  planned.power = static_cast<float>(full.power);
  const double normalisation = planned.is_power_of_pixel ? 1 : game_normalisation(full.power);
  for (std::size_t i = 0; i < full.f0.size(); ++i) {
    planned.f0[i] = static_cast<float>(full.f0[i] * normalisation);
    planned.f90[i] = static_cast<float>(full.f90[i] * normalisation);
  }
  planned.cutoff = rounded_down(of_material.cutoff);
  planned.least_exponent = rounded_down(shading.least_exponent);
  return planned;
}

double alpha_of_power(double power) {
  return std::min(1.0, std::sqrt(2 / (power + 2)));
}

}  // namespace shadefit::shade
