#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bench/shading/measure.hpp"
#include "bench/shading/picture.hpp"
#include "bench/shading/tables.hpp"
#include "tests/bench/shaded_scenes.hpp"

namespace shadefit::shade {
namespace {

using testing::one_material;
using testing::scene_of;
using testing::shaded_scenes;

TEST(Shade, PlansKeepWhatTheyPromiseOnEveryWidth) {
  for (const auto& [name, scene] : shaded_scenes()) {
    for (const scene::ShownScale scale : {scene::ShownScale::linear, scene::ShownScale::codes}) {
      const scene::Wanted wanted{.tolerance = scale == scene::ShownScale::linear ? 1.0 / 255 : 1,
                                 .lights = name == "several powers" ? 3 : 1,
                                 .scale = scale};
      const scene::Plan plan = scene::make_plan(scene, wanted);
      std::vector<Measurement> all;
      for (const Kernels& kernels : kernels_here()) all.push_back(measure(scene, plan, kernels, quick_plan));
      for (const Measurement& measured : all) {
        EXPECT_EQ(broken_lines(measured), "") << name << " by " << forms::name(measured.width);
        EXPECT_EQ(measured.sweep.size(), swept_tolerances.size());
        // culling depends on the width of the registers; everything else rounds the same
        EXPECT_NEAR(measured.planned.errors.most, all.front().planned.errors.most, measured.planned.allowed)
            << name;
        EXPECT_NEAR(measured.published.errors.most, all.front().published.errors.most, 1e-5) << name;
      }
    }
  }
}

TEST(Shade, SaysWhatIsSkipped) {
  const scene::Scene scene = shaded_scenes().at("one of two is black");
  const scene::Plan plan = scene::make_plan(scene, {});
  const Measurement measured = measure(scene, plan, kernels_here().front(), quick_plan);
  EXPECT_EQ(measured.skipped.by_materials, 0) << "a black material is skipped by every way";
  EXPECT_EQ(measured.samples, Workload(scene, 1).samples() / 2);
  EXPECT_GT(measured.skipped.by_terms, 0);
  EXPECT_LT(measured.skipped.by_terms, 1);
  EXPECT_GE(measured.skipped.by_culling, 0);
  EXPECT_LT(measured.skipped.by_culling, 1);
  EXPECT_EQ(shade_table(measured).rows.size(), 4 + swept_tolerances.size());
}

// The published lobe in the plan's kernel: the same samples are culled, and the error is that of the
// constants.
TEST(Shade, ThePublishedLobeIsAlsoMeasuredInThePlansKernel) {
  const scene::Scene scene = shaded_scenes().at("textured");
  const scene::Plan plan = scene::make_plan(scene, {.tolerance = 1.0 / 4096});
  const scene::Plan published = with_published_lobe(plan);
  EXPECT_EQ(published.shading.lobe.offset, 0.775);
  EXPECT_EQ(published.materials[0].cutoff, plan.materials[0].cutoff);
  const Measurement measured = measure(scene, plan, kernels_here().front(), quick_plan);
  EXPECT_NEAR(measured.published_culled.errors.most, measured.published.errors.most, 0.01);
  EXPECT_GT(measured.published_culled.errors.most, 10 * measured.planned.errors.most);
  EXPECT_LT(measured.reference.errors.most, 1e-4) << "the reference in float is off by roundings alone";
}

TEST(Shade, CountsTheOperationsOfASample) {
  // F: 1 - c, three products, and of each channel one multiply-add; (n + 2)/8 at hand; c^n is LOG2, MUL and
  // EXP2, nine; then three products and a minimum a channel
  EXPECT_EQ(full_operations(false), 4 + 3 * 2 + 9 + 3 * 4);
  EXPECT_GT(full_operations(true), full_operations(false));
  const PlannedMaterial linear{
      .kind = scene::LobeKind::multiplied, .whole = 1, .has_fresnel = false, .is_coloured = false};
  // with min(n.l, 2 n.h)
  EXPECT_EQ(planned_operations(linear), 3 + 2);
}

TEST(Shade, APlanThatIsBrokenIsToldWithBothNumbers) {
  Measurement measured{.width = forms::Width::sse2, .scale = scene::ShownScale::linear};
  measured.planned = {.name = "planned", .tolerance = 0.25, .form = "1", .ns = 1, .allowed = 0.125};
  measured.planned.errors.most = 0.5;
  EXPECT_EQ(
      broken_lines(measured),
      "shadefit: the plan for a tolerance of 0.25 is off by 0.5 of one light, which is above its 0.125\n");
  measured.planned.errors.most = 0;
  measured.on_device = DeviceMeasurement{.id = "vulkan:1", .ways = {4, measured.planned}};
  EXPECT_EQ(broken_lines(measured), "");
  measured.on_device->ways.back().errors.most = 0.25;
  EXPECT_EQ(
      broken_lines(measured),
      "shadefit: the plan for a tolerance of 0.25 is off by 0.25 of one light on vulkan:1, which is above its "
      "0.125\n");
}

TEST(ShadeWorkload, TakesPowersByTheirShares) {
  scene::Scene scene = scene_of({one_material(0.04, {{2, 0.75}, {200, 0.25}})});
  scene.materials.front().power_texture = scene::PowerTexture::roughness;
  const Workload workload(scene, 1);
  std::size_t sharp = 0, all = 0;
  for (const Visit& visit : workload.visits()) {
    for (std::size_t i = 0; i < std::get<std::vector<float>>(visit.alpha).size(); i += tile_pixels, ++all)
      sharp +=
          std::get<std::vector<float>>(visit.alpha)[i] < static_cast<float>(alpha_of_power(20)) ? 1U : 0U;
  }
  EXPECT_NEAR(static_cast<double>(sharp) / static_cast<double>(all), 0.25, 0.01);
}

TEST(ShadePicture, HasElevenSpheresAtMostAndNoBlackOnes) {
  const auto scenes = shaded_scenes();
  const auto count = [&](const char* name) {
    const scene::Scene& scene = scenes.at(name);
    return spheres_of(scene, scene::make_plan(scene, {})).size();
  };
  EXPECT_EQ(count("textured"), most_spheres);
  EXPECT_EQ(count("one of two is black"), 1U);
  EXPECT_EQ(count("nothing to see"), 2U) << "black, where there is nothing else";
}

}  // namespace
}  // namespace shadefit::shade
