#include <benchmark/benchmark.h>

#include <string>

#include "bench/solver/benchmarks.hpp"
#include "scene/materials/conversions.hpp"
#include "scene/plan/plan.hpp"

namespace shadefit::bench {
namespace {

/// Materials of every roughness, half of them metal, one power each.
scene::Scene scene_of(int materials) {
  scene::Scene made;
  for (int i = 0; i < materials; ++i) {
    scene::Material material;
    material.name = std::to_string(i);
    const bool is_metal = i % 2 == 1;
    material.f0.fill(is_metal ? scene::Range{0.9, 0.9} : scene::Range{0.04, 0.04});
    const double roughness = (i + 0.5) / materials;
    const auto power = [&](double stored) { return scene::power_of_roughness(stored, made.conventions); };
    scene::take_powers(material, {roughness, roughness}, power, scene::PowerTexture::none);
    made.materials.push_back(std::move(material));
  }
  return made;
}

void plan_scene(benchmark::State& state, double tolerance) {
  const scene::Scene scene = scene_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const scene::Plan plan = scene::make_plan(scene, {.tolerance = tolerance});
    require(plan.is_within(), "the plan is not within the tolerance");
    benchmark::DoNotOptimize(plan.error);
  }
}

}  // namespace

void register_scenes() {
  // Much less is not kept by the sharpest of 1000 materials: a GPU's log2 errs near 1.
  for (const int part : {32, 255}) {
    const std::string name = "scene/plan/tolerance:1/" + std::to_string(part);
    benchmark::RegisterBenchmark(name.c_str(), plan_scene, 1.0 / part)
        ->Arg(1)
        ->Arg(1000)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace shadefit::bench
