#include "bench/shade/ways.hpp"

namespace shadefit::shade {

ReferenceWay::ReferenceWay(const scene::Scene& scene, const Kernels& kernels) : kernels_(kernels) {
  for (const scene::Material& material : scene.materials) materials_.push_back(full_material(material));
}

void ReferenceWay::shade(const Block<double>& block, std::size_t material) const {
  kernels_.reference(block, materials_[material]);
}

PublishedWay::PublishedWay(const scene::Scene& scene, const Kernels& kernels) : kernels_(kernels) {
  for (const scene::Material& material : scene.materials)
    materials_.push_back(narrowed(full_material(material)));
}

void PublishedWay::shade(const Block<float>& block, std::size_t material) const {
  kernels_.published(block, materials_[material]);
}

PlannedWay::PlannedWay(const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels)
    : kernels_(kernels), is_coloured_(plan.shading.is_coloured) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    materials_.push_back(planned_material(scene.materials[i], plan.materials[i], plan.shading));
}

std::size_t PlannedWay::shade(const Block<float>& block, std::size_t material) const {
  const auto& planned = materials_[material];
  return planned ? kernels_.planned(block, *planned) : 0;
}

}  // namespace shadefit::shade
