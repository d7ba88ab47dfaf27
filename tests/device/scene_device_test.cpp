#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "approx/encoding.hpp"
#include "bench/device/scenes/measure_scene.hpp"
#include "reports/code/scene_code.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/bench/shaded_scenes.hpp"
#include "tests/device/drivers.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::device {
namespace {

using shade::FloatWay;
using shade::Way;
using testing::OnDriver;

/// Also the textures that the scenes of other tests do not have.
std::map<std::string, scene::Scene> scenes() {
  auto all = testing::shaded_scenes();
  scene::Scene textured = all.at("textured");
  textured.materials.front().power_texture = scene::PowerTexture::gloss;
  all["gloss"] = textured;
  textured.materials.front().power_texture = scene::PowerTexture::power;
  all["texture of powers"] = textured;
  textured.materials.front().power_texture = scene::PowerTexture::gloss;
  textured.materials.front().powers = {{2, 0.5}, {1000, 0.5}};
  textured.conventions.is_gloss_exponential = true;
  all["exponential gloss"] = textured;
  return all;
}

/// The plan without culling, and for the CPU with the best polynomial for exp2: the CPU culls registers and
/// has no exp2, so that it would differ by more than by roundings.
scene::Plan without_culling(scene::Plan plan) {
  for (scene::MaterialPlan& material : plan.materials) material.cutoff = 0;
  plan.shading.least_exponent = -std::numeric_limits<float>::max();
  constexpr int best = 6;
  if (plan.shading.exp2_degree > 0) plan.shading.exp2_degree = best;
  return plan;
}

/// The largest difference of two ways in 8-bit codes, over every eighth visit of a workload.
double largest_codes(const scene::Scene& scene, const Way& a, const Way& b) {
  const shade::Workload workload(scene, 1);
  shade::Results<float> of_a(workload.tiles()), of_b(workload.tiles());
  double most = 0;
  for (std::size_t i = 0; i < workload.visits().size(); i += 8) {
    const shade::Visit& visit = workload.visits()[i];
    shade::Block<float> block = workload.block<float>(visit);
    of_a.clear();
    of_b.clear();
    block.out = of_a.out();
    a.shade(block, visit.material);
    block.out = of_b.out();
    b.shade(block, visit.material);
    for (std::size_t c = 0; c < (a.is_coloured ? 3U : 1U); ++c) {
      for (std::size_t p = 0; p < of_a.channel(c).size(); ++p) {
        const auto code = [&](const auto& of) { return srgb_code(static_cast<double>(of.channel(c)[p])); };
        most = std::max(most, std::abs(code(of_a) - code(of_b)));
      }
    }
  }
  return most;
}

class SceneOnDriver : public OnDriver {
 protected:
  static SceneDevice device_for(const scene::Scene& scene, const scene::Plan& plan) {
    return {{.is_watched = true}, largest_pass(scene, plan)};
  }
};

INSTANTIATE_TEST_SUITE_P(Scenes, SceneOnDriver, ::testing::ValuesIn(testing::drivers),
                         ::testing::PrintToStringParamName());

TEST_P(SceneOnDriver, ShadesAsTheCpuDoes) {
  const shade::Kernels kernels = shade::kernels_here().front();
  for (const auto& [name, scene] : scenes()) {
    const scene::Plan plan = without_culling(scene::make_plan(scene, {}));
    SceneDevice device = device_for(scene, plan);
    const FloatWay planned(scene, plan, kernels), published(scene, kernels.published),
        reference(scene, kernels.reference);
    // log2 near 1 is off by 3e-7, times a power of 1000 and ln 2: 2.1e-4 of a light. Codes change most where
    // the light is near 1, by 110 times that. Other roundings are smaller.
    constexpr double codes = 0.03;
    EXPECT_LE(largest_codes(scene, way_of(planned), device.way(scene, planned_shader(scene, plan))), codes)
        << name;
    EXPECT_LE(largest_codes(scene, way_of(published), device.way(scene, published_shader(scene))), codes)
        << name;
    EXPECT_LE(largest_codes(scene, way_of(reference), device.way(scene, reference_shader(scene))), codes)
        << name;
    EXPECT_TRUE(device.device().messages().empty()) << device.device().messages().front();
  }
}

// A digit of the lobe's first constant is changed, in the device's code alone.
TEST_P(SceneOnDriver, AWrongConstantIsSeen) {
  const scene::Scene scene = scenes().at("several powers");
  const scene::Plan plan = without_culling(scene::make_plan(scene, {}));
  scene::Plan wrong = plan;
  ASSERT_FALSE(wrong.shading.lobe.slopes.empty());
  wrong.shading.lobe.slopes.front() += 0.1;
  SceneDevice device = device_for(scene, plan);
  const FloatWay planned(scene, plan, shade::kernels_here().front());
  EXPECT_GT(largest_codes(scene, way_of(planned), device.way(scene, planned_shader(scene, wrong))), 1);
}

TEST_P(SceneOnDriver, PlansKeepWhatTheyPromise) {
  const shade::Kernels kernels = shade::kernels_here().front();
  for (const char* name : {"one of two is textured", "coloured", "nothing to see"}) {
    const scene::Scene scene = scenes().at(name);
    const scene::Plan plan = scene::make_plan(scene, {.lights = 2});
    SceneDevice device = device_for(scene, plan);
    const shade::ReferenceWay reference(scene, kernels);
    const shade::DeviceMeasurement there = measure_scene(device, scene, plan, reference, shade::quick_plan);
    const shade::Measurement here = measure(scene, plan, kernels, shade::quick_plan);
    ASSERT_EQ(there.ways.size(), 4U);
    EXPECT_LE(there.ways[3].errors.most, there.ways[3].allowed) << name;
    EXPECT_EQ(there.ways[3].allowed, here.planned.allowed);
    // as above
    EXPECT_LE(there.ways[0].errors.most, 2.5e-4) << name;
    EXPECT_NEAR(there.ways[1].errors.most, here.published.errors.most, 1e-4) << name;
    EXPECT_EQ(there.pixels == 0, std::string(name) == "nothing to see");
    EXPECT_TRUE(device.device().messages().empty()) << device.device().messages().front();
  }
}

TEST_P(SceneOnDriver, WhatIsCulledIsBlack) {
  const scene::Scene scene = scenes().at("one power");
  const scene::Plan plan = scene::make_plan(scene, {});
  const float cutoff = planned_shader(scene, plan).materials.front().cutoff;
  ASSERT_GT(cutoff, 0);
  SceneDevice device = device_for(scene, plan);
  shade::Cosines cosines(1, 1);
  for (std::size_t p = 0; p < shade::tile_pixels; ++p) {
    const auto n_dot_h = static_cast<double>(p % 2 == 0 ? cutoff : std::nextafter(cutoff, 0.0F));
    cosines.set(0, 0, p, {n_dot_h, 1, 1});
  }
  shade::Results<float> results(1);
  shade::Block<float> block = cosines.block<float>();
  block.out = results.out();
  device.way(scene, planned_shader(scene, plan)).shade(block, 0);
  for (std::size_t p = 0; p < shade::tile_pixels; ++p) EXPECT_EQ(results.channel(0)[p] > 0, p % 2 == 0) << p;
}

TEST_P(SceneOnDriver, TheCommandPrintsItBesideTheCpu) {
  const testing::TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", "newmtl shiny\nNs 20\nKs 0.5 0.4 0.3\nillum 2\n");
  const Outcome outcome =
      run_command_line({"scene", file, "--shade", "--device", "vulkan", "--out", directory / "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"\ndevice    way  ", "\nCPU       planned  ", "\nvulkan:0  reference  ",
                           "\nvulkan:0  planned  ", "\nvulkan:0 is ", "\nTimed there: "})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << outcome.out;
  const std::string table = read_file(directory / "out/shade.csv");
  EXPECT_NE(table.find(",CPU\n"), std::string::npos) << table;
  EXPECT_NE(table.find(vulkan_devices().front().name), std::string::npos) << table;
}

TEST_P(SceneOnDriver, AMissingDeviceIsNamedBeforeAnythingIsWritten) {
  const testing::TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", "newmtl shiny\nNs 20\nKs 0.5 0.4 0.3\nillum 2\n");
  testing::expect_refusal({"scene", file, "--shade", "--device", "vulkan:7", "--out", directory / "out"},
                          "--device 'vulkan:7': this machine has 1 device that can compute");
  EXPECT_FALSE(std::filesystem::exists(directory / "out"));
}

TEST(SceneDevice, IsForShade) {
  testing::expect_refusal({"scene", "a.mtl", "--device", "vulkan"},
                          "--device requires --shade (see 'shadefit help scene')");
}

// The code of the shader is the text that `scene --lang glsl` writes, below its comment.
TEST(SceneShader, HoldsTheEmittedText) {
  for (const auto& [name, scene] : scenes()) {
    const scene::Plan plan = scene::make_plan(scene, {});
    const std::string emitted = scene_code(scene, plan, Language::glsl, "");
    const std::size_t code = emitted.find("\n\n//");
    if (!plan.has_lobes()) continue;
    ASSERT_NE(code, std::string::npos) << emitted;
    EXPECT_NE(glsl_of(planned_shader(scene, plan)).find(emitted.substr(code + 2)), std::string::npos)
        << name << emitted;
  }
}

}  // namespace
}  // namespace shadefit::device
