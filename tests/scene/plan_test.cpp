#include "scene/plan/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shadefit::scene {
namespace {

Material material(const std::string& name, double reflectance, const Range& power) {
  Material made;
  made.name = name;
  made.f0.fill({reflectance, reflectance});
  made.power = power;
  return made;
}

/// Of Wavefront's format: Ks times the lobe.
Material wavefront(const std::string& name, double ks, double ns) {
  Material made = material(name, ks, {ns, ns});
  made.fresnel = FresnelTerm::none;
  return made;
}

const Decision& decision(const Plan& plan, const std::string& term) {
  for (const Decision& d : plan.decisions) {
    if (d.term == term) return d;
  }
  throw std::logic_error("no decision on " + term);
}

// Twenty materials, of which one shines, with a power of 1.
TEST(Plan, SkipsWhatIsBlack) {
  Scene scene;
  for (int i = 0; i < 19; ++i) scene.materials.push_back(wavefront("black " + std::to_string(i), 0, 50));
  scene.materials.push_back(wavefront("floor", 0.5, 1));
  const Plan plan = make_plan(scene, {});
  EXPECT_TRUE(plan.is_within());
  EXPECT_TRUE(plan.has_lobes());
  const Decision& specular = decision(plan, "specular lobe");
  EXPECT_EQ(specular.treatment, Treatment::replace);
  EXPECT_EQ(specular.form, "for 1 of 20 materials");
  EXPECT_EQ(specular.reason, "skipped for 19 of 20 materials");
  EXPECT_EQ(plan.materials[0].reason, "black specular colour");
  EXPECT_FALSE(plan.materials[0].has_lobe);
  EXPECT_TRUE(plan.materials[19].has_lobe);
  EXPECT_EQ(decision(plan, "lobe").form, "c^1 by multiplications");
  EXPECT_EQ(decision(plan, "lobe").error, 0);
  EXPECT_EQ(decision(plan, "Fresnel").treatment, Treatment::skip);
  EXPECT_EQ(decision(plan, "normalisation").form, "0.375");
  EXPECT_EQ(decision(plan, "coloured F0").form, "one channel");
  EXPECT_EQ(decision(plan, "gloss decode").treatment, Treatment::skip);
}

TEST(Plan, OfASceneWithoutSpecularIsEmpty) {
  Scene scene;
  scene.materials = {wavefront("black", 0, 50), material("unlit", 0.04, {20, 20})};
  scene.materials[1].is_unlit = true;
  const Plan plan = make_plan(scene, {});
  for (const Decision& d : plan.decisions) {
    EXPECT_EQ(d.treatment, Treatment::skip) << d.term;
    EXPECT_EQ(d.error, 0) << d.term;
  }
  EXPECT_EQ(plan.materials[1].reason, "unlit");
  EXPECT_EQ(plan.error, 0);
  EXPECT_FALSE(plan.has_lobes());
}

/// A dull dielectric with powers from a texture.
Scene dull_scene() {
  Scene scene;
  Material dull = wavefront("dull", 0.04, 0);
  dull.power = {10.5, 20.5};
  dull.power_texture = PowerTexture::roughness;
  scene.materials = {dull};
  return scene;
}

// 0.04 (n + 2)/8 is small, and a Gaussian is near enough; with the tolerance its form changes.
TEST(Plan, TakesTheCheapestFormThatIsNearEnough) {
  struct Expected {
    double tolerance;
    LobeKind kind;
    std::size_t slopes;
    bool has_offset;
  };
  const Scene scene = dull_scene();
  for (const Expected& expected : {Expected{1.0 / 64, LobeKind::exponential, 1, false},
                                   Expected{1.0 / 640, LobeKind::exponential, 1, true},
                                   Expected{1.0 / 4096, LobeKind::exponential, 2, false},
                                   Expected{1.0 / 32768, LobeKind::exponential, 3, false},
                                   Expected{1.0 / 262144, LobeKind::exponential, 4, false},
                                   Expected{1.2e-6, LobeKind::power, 0, false}}) {
    const Plan plan = make_plan(scene, {.tolerance = expected.tolerance});
    EXPECT_EQ(plan.shading.lobe.kind, expected.kind) << expected.tolerance;
    EXPECT_EQ(plan.shading.lobe.slopes.size(), expected.slopes) << expected.tolerance;
    EXPECT_EQ(plan.shading.lobe.offset != 0, expected.has_offset) << expected.tolerance;
    EXPECT_TRUE(plan.is_within()) << expected.tolerance << " " << plan.error;
  }
}

// Lights share the tolerance; a display's codes are stricter near black; halves cannot keep a tight one.
TEST(Plan, LightsCodesAndHalves) {
  const Scene scene = dull_scene();
  const Plan lights = make_plan(scene, {.tolerance = 1.0 / 512, .lights = 16});
  EXPECT_GT(lights.shading.lobe.slopes.size(), 1U);
  EXPECT_TRUE(lights.is_within());
  EXPECT_EQ(decision(lights, "power").form, "for each pixel");
  EXPECT_EQ(decision(lights, "gloss decode").treatment, Treatment::keep);
  Scene powers = scene;
  powers.materials[0].power_texture = PowerTexture::power;
  EXPECT_EQ(decision(make_plan(powers, {}), "gloss decode").treatment, Treatment::skip);
  EXPECT_TRUE(make_plan(powers, {}).shading.is_power_of_pixel);
  const Plan codes = make_plan(scene, {.tolerance = 0.5, .scale = ShownScale::codes});
  EXPECT_TRUE(codes.is_within());
  EXPECT_GT(codes.shading.lobe.slopes.size(), 1U) << "0.5/255 in linear values is a Gaussian's";
  const Plan half = make_plan(scene, {.tolerance = 1.0 / 255, .precision = PixelPrecision::float16});
  EXPECT_TRUE(half.is_within());
  EXPECT_GT(decision(half, "rounding").error, decision(lights, "rounding").error);
  EXPECT_FALSE(make_plan(scene, {.tolerance = 1e-5, .precision = PixelPrecision::float16}).is_within());
}

TEST(Plan, KeepsFresnelWhereItRises) {
  Scene scene;
  scene.materials = {material("glass", 0.04, {16, 16})};
  EXPECT_TRUE(make_plan(scene, {}).shading.has_fresnel);
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").reason, "every reflectance is grey");
  scene.materials[0].f90 = {0.0402, 0.0402};
  const Plan flat = make_plan(scene, {});
  EXPECT_FALSE(flat.shading.has_fresnel);
  EXPECT_EQ(decision(flat, "Fresnel").treatment, Treatment::skip);
  EXPECT_GT(decision(flat, "Fresnel").error, 0);
  scene.materials[0].f0[2] = {0.9, 0.9};
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").reason, "a reflectance is coloured");
  scene.materials[0].f0[2] = scene.materials[0].f0[0];
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").treatment, Treatment::replace);
  scene.materials[0].has_unread_colours = true;
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").treatment, Treatment::keep)
      << "ranges agree, the channels of a pixel need not";
}

// A filter gives values between two texels: for a mask from 0 to 1 every power.
TEST(Plan, OfFilteredTextures) {
  Scene scene;
  Material mask = wavefront("mask", 1, 0);
  mask.power = {0, 1e9};
  mask.power_texture = PowerTexture::roughness;
  scene.materials = {mask};
  const Plan plan = make_plan(scene, {});
  EXPECT_TRUE(plan.is_within());
  EXPECT_GT(plan.shading.lobe.slopes.size(), 1U) << "0 and 1e9 alone want a Gaussian, 30 does not";
}

TEST(Plan, OfAConstantLobe) {
  Scene scene;
  scene.materials = {wavefront("rough", 1, 0)};
  const Plan plan = make_plan(scene, {});
  EXPECT_EQ(decision(plan, "lobe").treatment, Treatment::skip);
  EXPECT_EQ(decision(plan, "lobe").reason, "every power is 0");
  // 0.001 (0 + 2)/8 is less than a code
  scene.materials = {wavefront("faint", 0.001, 0)};
  const Plan faint = make_plan(scene, {});
  EXPECT_FALSE(faint.materials[0].has_lobe);
  EXPECT_EQ(faint.materials[0].reason, "at most 0.00025 of a light");
  EXPECT_EQ(faint.error, 0.00025);
}

// Exponents by multiplications only where they are cheap: 15 takes six, 255 fourteen.
TEST(Plan, MultipliesOneWholePower) {
  Scene scene;
  for (const auto& [power, kind] : {std::pair{15.0, LobeKind::multiplied},
                                    {64.0, LobeKind::multiplied},
                                    {255.0, LobeKind::exponential},
                                    {15.5, LobeKind::exponential}}) {
    scene.materials = {wavefront("one", 0.04, power)};
    EXPECT_EQ(make_plan(scene, {.tolerance = 1.0 / 64}).shading.lobe.kind, kind) << power;
  }
  scene.materials = {wavefront("one", 0.04, 15), wavefront("other", 0.04, 16)};
  EXPECT_EQ(make_plan(scene, {.tolerance = 1.0 / 64}).shading.lobe.kind, LobeKind::exponential);
}

// The total error by brute force: the plan against the shading formula.
TEST(Plan, KeepsItsPromise) {
  Scene scene;
  scene.materials = {wavefront("a", 0.04, 10.5), wavefront("b", 0.03, 33.25), wavefront("c", 0.9, 800)};
  for (const double tolerance : {1.0 / 32, 1.0 / 255, 1.0 / 2048}) {
    const Plan plan = make_plan(scene, {.tolerance = tolerance});
    ASSERT_EQ(plan.shading.lobe.kind, LobeKind::exponential);
    double largest = 0;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
      const MaterialPlan& material = plan.materials[m];
      const double power = scene.materials[m].power.most;
      for (int i = 0; i <= 20000; ++i) {
        const double c = i < 10000 ? i / 10000.0 : 1 - (i - 10000) * 1e-6;
        const LobeForm& lobe = plan.shading.lobe;
        const double form = planned_lobe<double>(lobe, c, {lobe.slopes, power + lobe.offset});
        const double light = material.factor * std::min(1.0, 2 * c);
        const double planned = material.has_lobe ? std::min(1.0, light * form) : 0;
        largest = std::max(largest, std::abs(planned - std::min(1.0, light * std::pow(c, power))));
      }
    }
    EXPECT_LE(largest, plan.error) << tolerance;
    EXPECT_GE(largest, 0.8 * decision(plan, "lobe").error) << tolerance << ": and it is no idle one";
  }
}

TEST(Plan, SaysWhatItDoesNotCount) {
  Scene scene;
  scene.materials = {material("mirror", 0.04, {263279, 263279})};
  EXPECT_TRUE(make_plan(scene, {}).notes.empty()) << "0.0525 is as engines have it";
  scene.materials.push_back(material("smoother", 0.04, {1e9, 1e9}));
  EXPECT_TRUE(make_plan(scene, {}).notes.at(0).starts_with("the roughness of 1 material falls below 0.045"));
  scene.conventions.min_roughness = 0.05;
  EXPECT_EQ(make_plan(scene, {}).notes, std::vector<std::string>{"a roughness below 0.05 is taken for it"});
  scene.conventions.min_roughness = 0;
  scene.materials = {wavefront("sharp", 0.04, 1e9)};
  EXPECT_TRUE(make_plan(scene, {}).notes.empty()) << "Ns is no roughness";
}

TEST(Plan, OfEqualPowersTheBrightestCounts) {
  const std::vector<Material> materials{wavefront("a", 0.04, 10), wavefront("b", 0.5, 10),
                                        wavefront("c", 0.01, 10)};
  const Lobes lobes = lobes_of(materials, {true, true, true});
  ASSERT_EQ(lobes.all.size(), 1U);
  EXPECT_EQ(lobes.all[0].factor, 0.5 * 12 / 8);
}

}  // namespace
}  // namespace shadefit::scene
