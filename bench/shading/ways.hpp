#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "bench/shading/workload.hpp"
#include "scene/plan/plan.hpp"

/// The ways to shade a workload.
namespace shadefit::shade {

/// Every material of a scene with all of its terms, by the reference's formulas in double.
class ReferenceWay {
 public:
  ReferenceWay(const scene::Scene& scene, const Kernels& kernels);
  void shade(const Block<double>& block, std::size_t material) const;

 private:
  Kernels kernels_;
  std::vector<FullMaterial<double>> materials_;
};

/// Whether a material is black or not shaded. Every way tests this first.
bool is_black(const scene::Material& material);

/// A way in float: all terms for the materials that are not black, or a plan.
class FloatWay {
 public:
  FloatWay(const scene::Scene& scene, FullKernel<float> kernel);
  FloatWay(const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels);

  /// Returns the number of culled samples. A material without a lobe writes nothing; a plan with one channel
  /// writes only the first.
  std::size_t shade(const Block<float>& block, std::size_t material) const;

  bool has_lobe(std::size_t material) const;
  bool is_coloured() const { return is_coloured_; }

 private:
  // With one of the kernels, and its materials; those without a lobe are empty.
  FullKernel<float> full_kernel_ = nullptr;
  PlannedKernel planned_kernel_ = nullptr;
  std::vector<std::optional<FullMaterial<float>>> full_;
  std::vector<std::optional<PlannedMaterial>> planned_;
  bool is_coloured_ = true;
};

/// A way as the errors and the picture see it: on this processor or on another device. `shade` is that of
/// `FloatWay`.
struct Way {
  std::function<void(const Block<float>& block, std::size_t material)> shade;
  bool is_coloured = true;
};

/// A way on this processor, which must outlive the result.
Way way_of(const FloatWay& way);

/// The plan with the published Gaussian as its lobe, to compare the constants in the same kernel.
scene::Plan with_published_lobe(scene::Plan plan);

}  // namespace shadefit::shade
