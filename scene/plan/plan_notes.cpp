#include "scene/plan/plan_notes.hpp"

#include "fit/support/decimal.hpp"
#include "scene/materials/powers.hpp"

namespace shadefit::scene {
namespace {

/// The number of materials with a lobe and a roughness below the minimum of engines.
long smooth_materials(const Scene& scene, const Plan& plan) {
  const double most = power_of_roughness(least_engine_roughness, scene.conventions);
  long smooth = 0;
  for (std::size_t i = 0; i < plan.materials.size(); ++i) {
    const bool has_roughness = scene.materials[i].fresnel == FresnelTerm::schlick;
    if (plan.materials[i].has_lobe && has_roughness && plan.materials[i].power.most > most) ++smooth;
  }
  return smooth;
}

}  // namespace

std::vector<std::string> notes_of(const Scene& scene, const Plan& plan) {
  std::vector<std::string> notes;
  const PixelPrecision precision = plan.wanted.precision;
  if (plan.dot_product_error > 0) {
    notes.push_back("n.h by a dot product in " + std::string(name(precision)) + " is off by " +
                    decimal_above(dot_product_rounding(precision), 3) + ", which moves a light by up to " +
                    decimal_above(plan.dot_product_error, 2) + " more, whatever the form: not counted");
  }
  const double least = scene.conventions.min_roughness;
  if (least > 0) {
    notes.push_back("a roughness below " + decimal(least, 4) + " is taken for it");
  } else if (const long smooth = smooth_materials(scene, plan); smooth > 0) {
    notes.push_back("the roughness of " + counted(smooth, "material") +
                    " falls below 0.045, the least that engines keep (Filament; three.js has 0.0525): "
                    "--min-roughness takes it for more");
  }
  return notes;
}

}  // namespace shadefit::scene
