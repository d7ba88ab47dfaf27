#include "bench/shading/ways.hpp"

#include "bench/shading/kernels/full_terms.hpp"
#include "scene/plan/choose_exp2.hpp"
#include "scene/plan/lobes.hpp"

namespace shadefit::shade {

ReferenceWay::ReferenceWay(const scene::Scene& scene, const Kernels& kernels) : kernels_(kernels) {
  for (const scene::Material& material : scene.materials) materials_.push_back(full_material(material));
}

void ReferenceWay::shade(const Block<double>& block, std::size_t material) const {
  kernels_.truth(block, materials_[material]);
}

bool is_black(const scene::Material& material) {
  return material.is_unlit || scene::largest_reflectance(material) == 0;
}

FloatWay::FloatWay(const scene::Scene& scene, FullKernel<float> kernel) : full_kernel_(kernel) {
  for (const scene::Material& material : scene.materials) {
    full_.emplace_back();
    if (!is_black(material)) full_.back() = narrowed(full_material(material));
  }
}

FloatWay::FloatWay(const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels)
    : planned_kernel_(kernels.planned), is_coloured_(plan.shading.is_coloured) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    planned_.push_back(planned_material(scene.materials[i], plan.materials[i], plan.shading));
}

std::size_t FloatWay::shade(const Block<float>& block, std::size_t material) const {
  if (!has_lobe(material)) return 0;
  if (planned_kernel_ != nullptr) return planned_kernel_(block, *planned_[material]);
  full_kernel_(block, *full_[material]);
  return 0;
}

bool FloatWay::has_lobe(std::size_t material) const {
  return planned_kernel_ != nullptr ? planned_[material].has_value() : full_[material].has_value();
}

Way way_of(const FloatWay& way) {
  return {[&way](const Block<float>& block, std::size_t material) { way.shade(block, material); },
          way.is_coloured()};
}

scene::Plan with_published_lobe(scene::Plan plan) {
  scene::PlannedShading& shading = plan.shading;
  if (!plan.has_lobes()) return plan;
  shading.lobe = {.kind = scene::LobeKind::exponential,
                  .offset = published_constant<PublishedOffset, double>(),
                  .slopes = {scene::natural_slope},
                  .is_fused = !shading.is_power_of_pixel};
  if (shading.exp2_degree == 0)
    shading.exp2_degree = scene::choose_exp2(plan.wanted.tolerance, plan.wanted.scale).degree;
  return plan;
}

}  // namespace shadefit::shade
