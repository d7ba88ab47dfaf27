#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/shade/workload.hpp"
#include "scene/plan.hpp"

/// The three ways to shade a workload.
namespace shadefit::shade {

/// Every material of a scene with all of its terms, by the reference's formulas.
class ReferenceWay {
 public:
  ReferenceWay(const scene::Scene& scene, const Kernels& kernels);
  void shade(const Block<double>& block, std::size_t material) const;

 private:
  Kernels kernels_;
  std::vector<FullMaterial<double>> materials_;
};

/// The same by the published constants.
class PublishedWay {
 public:
  PublishedWay(const scene::Scene& scene, const Kernels& kernels);
  void shade(const Block<float>& block, std::size_t material) const;

 private:
  Kernels kernels_;
  std::vector<FullMaterial<float>> materials_;
};

/// As a plan has it.
class PlannedWay {
 public:
  PlannedWay(const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels);
  /// Returns how many samples were culled. A material without a lobe writes nothing; one whose plan has one
  /// channel, the first alone.
  std::size_t shade(const Block<float>& block, std::size_t material) const;

  bool has_lobe(std::size_t material) const { return materials_[material].has_value(); }
  bool is_coloured() const { return is_coloured_; }

 private:
  Kernels kernels_;
  std::vector<std::optional<PlannedMaterial>> materials_;
  bool is_coloured_;
};

}  // namespace shadefit::shade
