#include "scene/plan/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/plan/choose_exp2.hpp"
#include "scene/plan/lobe_error.hpp"
#include "scene/plan/lobe_fit.hpp"
#include "scene/plan/lobes.hpp"

namespace shadefit::scene {
namespace {

Material material(const std::string& name, double reflectance, std::vector<PowerShare> powers) {
  Material made;
  made.name = name;
  made.f0 = {Range{reflectance, reflectance}, Range{reflectance, reflectance},
             Range{reflectance, reflectance}};
  made.powers = std::move(powers);
  return made;
}

/// Of Wavefront's format: Ks times the lobe.
Material wavefront(const std::string& name, double ks, double ns) {
  Material made = material(name, ks, {{ns, 1}});
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
  EXPECT_EQ(decision(plan, "exp2").treatment, Treatment::skip);
  EXPECT_EQ(decision(plan, "Fresnel").treatment, Treatment::skip);
  EXPECT_EQ(decision(plan, "normalisation").form, "0.375");
  EXPECT_EQ(decision(plan, "coloured F0").form, "one channel");
  EXPECT_EQ(decision(plan, "gloss decode").treatment, Treatment::skip);
  EXPECT_EQ(plan.fits_run, 0);
  // 2 c c 0.5 3/8 = 0.1/255
  const double cutoff = std::sqrt(0.1 / 255 / (2 * 0.1875));
  EXPECT_NEAR(plan.materials[19].cutoff, cutoff, 1e-9);
  EXPECT_LE(plan.materials[19].cutoff, cutoff);
}

TEST(Plan, OfASceneWithoutSpecularIsEmpty) {
  Scene scene;
  scene.materials = {wavefront("black", 0, 50), material("unlit", 0.04, {{20, 1}})};
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

/// A dull dielectric with two powers from a texture.
Scene dull_scene() {
  Scene scene;
  Material dull = wavefront("dull", 0.04, 0);
  dull.powers = {{10.5, 0.5}, {20.5, 0.5}};
  dull.power_texture = PowerTexture::roughness;
  scene.materials = {dull};
  return scene;
}

// 0.04 (n + 2)/8 is small, and a Gaussian is near enough; with the tolerance its form changes. Unneeded forms
// are not fitted: each rejected form costs its fit.
TEST(Plan, TakesTheCheapestFormThatIsNearEnough) {
  struct Expected {
    double tolerance;
    LobeKind kind;
    std::size_t slopes;
    bool has_offset;
    int fits;
  };
  const Scene scene = dull_scene();
  for (const Expected& expected : {Expected{1.0 / 64, LobeKind::exponential, 1, false, 0},
                                   Expected{1.0 / 512, LobeKind::exponential, 1, true, 2},
                                   Expected{1.0 / 4096, LobeKind::exponential, 2, false, 3},
                                   Expected{1.0 / 32768, LobeKind::exponential, 3, false, 4},
                                   Expected{1.0 / 262144, LobeKind::exponential, 4, false, 5},
                                   Expected{1.2e-6, LobeKind::power, 0, false, 4}}) {
    const Plan plan = make_plan(scene, {.tolerance = expected.tolerance});
    EXPECT_EQ(plan.shading.lobe.kind, expected.kind) << expected.tolerance;
    EXPECT_EQ(plan.shading.lobe.slopes.size(), expected.slopes) << expected.tolerance;
    EXPECT_EQ(plan.shading.lobe.offset != 0, expected.has_offset) << expected.tolerance;
    EXPECT_EQ(plan.fits_run, expected.fits) << expected.tolerance;
    EXPECT_EQ(plan.fits_run + plan.fits_skipped,
              make_plan(scene, {}).fits_run + make_plan(scene, {}).fits_skipped);
    EXPECT_TRUE(plan.is_within()) << expected.tolerance << " " << plan.error;
    EXPECT_EQ(decision(plan, "offset x").treatment, expected.has_offset ? Treatment::keep : Treatment::skip);
  }
}

// Two textures between the same powers: the form is the same, its constants are those of the texels.
TEST(Plan, WhatIsUsedDrivesTheConstants) {
  struct Made {
    LobeForm lobe;
    std::string reason;
  };
  for (const double tolerance : {1.0 / 512, 1.0 / 4096, 1.0 / 32768}) {
    std::vector<Made> made;
    for (const double blunt : {0.999, 0.001}) {
      Scene scene = dull_scene();
      scene.materials[0].powers[0].share = blunt;
      scene.materials[0].powers[1].share = 1 - blunt;
      const Plan plan = make_plan(scene, {.tolerance = tolerance});
      EXPECT_TRUE(plan.is_within()) << tolerance << " " << plan.error;
      made.push_back({plan.shading.lobe, decision(plan, "lobe").reason});
      EXPECT_NE(made.back().reason.find("powers weighted by their use: "), std::string::npos)
          << made.back().reason;
    }
    EXPECT_EQ(made[0].lobe.slopes.size(), made[1].lobe.slopes.size()) << tolerance;
    EXPECT_NE(made[0].lobe, made[1].lobe) << tolerance;
  }
}

// A dearer exp2 is no price for a smaller mean error: its degree is that which goes with the constants of the
// least largest error.
TEST(Plan, ConstantsOfUseCostNoInstruction) {
  // hardly a texel has the power that errs most, so that the least mean error is far from the least largest
  Scene scene = dull_scene();
  scene.materials[0].powers = {{2, 0.999}, {200, 0.001}};
  const Lobes lobes = lobes_of(scene.materials, {true});
  int sloped = 0;
  for (double tolerance = 1.0 / 2048; tolerance > 8e-5;
       tolerance /= 1.05) {  // below, log2 is too coarse for a power of 200
    const Plan plan = make_plan(scene, {.tolerance = tolerance});
    EXPECT_TRUE(plan.is_within()) << tolerance << " " << plan.error;
    const auto count = static_cast<int>(plan.shading.lobe.slopes.size());
    if (count < 2) continue;
    ++sloped;
    LobeFitter fitter(lobes.all, ShownScale::linear);
    const LobeCells cells(fitter.best_slopes(count), lobes.range().most);
    double error = 0;
    for (const WeightedPower& lobe : lobes.all)
      error = std::max(error, cells.largest_error(lobe, 0, ShownScale::linear, error));
    // Ks without Fresnel: the cut-off has a tenth, the lobe, the roundings and exp2 share the rest
    const double left = 0.9 * tolerance - error - decision(plan, "rounding").error;
    EXPECT_EQ(plan.shading.exp2_degree, choose_exp2(left, ShownScale::linear).degree) << tolerance;
  }
  EXPECT_GE(sloped, 10) << "plans of which this says something";
}

// Lights share the tolerance; a display's codes are stricter near black; halves cannot keep a tight one.
TEST(Plan, LightsCodesAndHalves) {
  const Scene scene = dull_scene();
  const Plan lights = make_plan(scene, {.tolerance = 1.0 / 512, .lights = 16});
  EXPECT_GT(lights.shading.lobe.slopes.size(), 1U);
  EXPECT_TRUE(lights.is_within());
  EXPECT_EQ(decision(lights, "power").form, "for each pixel");
  EXPECT_EQ(decision(lights, "gloss decode").treatment, Treatment::keep);
  const Plan codes = make_plan(scene, {.tolerance = 0.5, .scale = ShownScale::codes});
  EXPECT_TRUE(codes.is_within());
  EXPECT_GT(codes.shading.lobe.slopes.size(), 1U) << "0.5/255 in linear values is a Gaussian's";
  const Plan half = make_plan(scene, {.tolerance = 1.0 / 255, .precision = PixelPrecision::float16});
  EXPECT_TRUE(half.is_within());
  EXPECT_GT(decision(half, "rounding").error, decision(lights, "rounding").error);
  EXPECT_FALSE(make_plan(scene, {.tolerance = 1e-5, .precision = PixelPrecision::float16}).is_within());
}

TEST(Plan, DecodesWhatTexturesHold) {
  Scene scene = dull_scene();
  EXPECT_EQ(decision(make_plan(scene, {}), "gloss decode").form, "n = 2/alpha^2 - 2");
  scene.materials[0].power_texture = PowerTexture::power;
  EXPECT_EQ(decision(make_plan(scene, {}), "gloss decode").treatment, Treatment::skip);
  EXPECT_TRUE(make_plan(scene, {}).shading.is_power_of_pixel);
  scene.materials[0].power_texture = PowerTexture::gloss;
  EXPECT_EQ(decision(make_plan(scene, {}), "gloss decode").form, "n = 2/alpha^2 - 2");
  scene.conventions.is_gloss_exponential = true;
  EXPECT_EQ(decision(make_plan(scene, {}), "gloss decode").form, "n = 2^(10 g + 1)");
  scene.materials.push_back(dull_scene().materials[0]);
  EXPECT_EQ(decision(make_plan(scene, {}), "gloss decode").form, "n = 2/alpha^2 - 2 and n = 2^(10 g + 1)");
}

TEST(Plan, KeepsFresnelWhereItRises) {
  Scene scene;
  scene.materials = {material("glass", 0.04, {{16, 1}})};
  EXPECT_TRUE(make_plan(scene, {}).shading.has_fresnel);
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").reason, "every reflectance is grey, no metal");
  scene.materials[0].f90 = {0.0402, 0.0402};
  const Plan flat = make_plan(scene, {});
  EXPECT_FALSE(flat.shading.has_fresnel);
  EXPECT_EQ(decision(flat, "Fresnel").treatment, Treatment::skip);
  EXPECT_GT(decision(flat, "Fresnel").error, 0);
  scene.materials[0].f0[2] = {0.9, 0.9};
  EXPECT_TRUE(make_plan(scene, {}).shading.is_coloured);
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").reason,
            "a reflectance is coloured, metals among them");
  scene.materials[0].f0[2] = scene.materials[0].f0[0];
  EXPECT_FALSE(make_plan(scene, {}).shading.is_coloured);
  scene.materials[0].has_unread_colours = true;
  EXPECT_TRUE(make_plan(scene, {}).shading.is_coloured) << "ranges agree, the channels of a pixel need not";
}

// A filter gives values between two texels: for a mask from 0 to 1 every power.
TEST(Plan, OfFilteredTextures) {
  Scene scene;
  Material mask = wavefront("mask", 1, 0);
  mask.powers = {{0, 0.5}, {1e9, 0.5}};
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
  // no cosine n.h is asked, so that none is bounded
  EXPECT_EQ(plan.materials[0].cutoff, 0);
  EXPECT_EQ(decision(plan, "culling").treatment, Treatment::skip);
  EXPECT_EQ(decision(plan, "n.v < 0").treatment, Treatment::skip);
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
      const double power = scene.materials[m].powers[0].power;
      for (int i = 0; i <= 20000; ++i) {
        const double c = i < 10000 ? i / 10000.0 : 1 - (i - 10000) * 1e-6;
        double exponent = 0;
        const auto& slopes = plan.shading.lobe.slopes;
        for (std::size_t j = slopes.size(); j > 0; --j) exponent = (c - 1) * (slopes[j - 1] + exponent);
        const double light = material.factor * std::min(1.0, 2 * c);
        const double form = std::exp2((power + plan.shading.lobe.offset) * exponent);
        const bool is_skipped = c < material.cutoff || !material.has_lobe;
        const double planned = is_skipped ? 0 : std::min(1.0, light * form);
        largest = std::max(largest, std::abs(planned - std::min(1.0, light * std::pow(c, power))));
      }
    }
    EXPECT_LE(largest, plan.error) << tolerance;
    EXPECT_GE(largest, 0.8 * decision(plan, "lobe").error) << tolerance << ": and it is no idle one";
  }
}

// Below the cut-off no power of the range shows more than the error that is set aside, and hardly above it
// one does.
TEST(Plan, CutsOffForEveryPowerOfARange) {
  for (const double reflectance : {1e-3, 0.04, 1.0}) {
    for (const Range range : {Range{0, 40}, Range{0.02, 0.5}, Range{3, 1e6}, Range{0, 1e9}}) {
      Scene scene;
      scene.materials = {wavefront("a", reflectance, 0)};
      scene.materials[0].powers = {{range.least, 0.5}, {range.most, 0.5}};
      scene.materials[0].power_texture = PowerTexture::power;
      const Plan plan = make_plan(scene, {});
      if (!plan.materials[0].has_lobe) continue;
      const double c = plan.materials[0].cutoff, set_aside = 0.1 / 255;
      const auto brightest = [&](double cosine) {
        double most = 0;
        for (int i = 0; i <= 4000; ++i) {
          const double share = i / 4000.0;
          const double n = range.least + (range.most - range.least) * std::pow(share, 6);
          most = std::max(most, reflectance * (n + 2) / 8 * std::pow(cosine, n) * std::min(1.0, 2 * cosine));
        }
        return most;
      };
      EXPECT_LE(brightest(c), set_aside) << reflectance << " " << range.most;
      if (c >= 0.9) continue;
      EXPECT_GE(brightest(1.1 * c), set_aside) << reflectance << " " << range.most;
    }
  }
}

TEST(Plan, SaysWhatItDoesNotCount) {
  const auto notes = [](const Scene& scene, const Wanted& wanted = {}) {
    std::string all;
    for (const std::string& note : make_plan(scene, wanted).notes) all += note + "\n";
    return all;
  };
  Scene scene;
  scene.materials = {material("mirror", 0.04, {{263279, 1}})};
  const std::string said = notes(scene);
  EXPECT_NE(
      said.find("n.h by a dot product in float is off by 1.79e-07, which moves a light by up to 0.046 more"),
      std::string::npos)
      << said;
  EXPECT_EQ(said.find("--min-roughness"), std::string::npos) << "0.0525 is as engines have it: " << said;
  scene.materials.push_back(material("smoother", 0.04, {{1e9, 1}}));
  EXPECT_NE(notes(scene).find("the roughness of 1 material falls below 0.045"), std::string::npos);
  scene.conventions.min_roughness = 0.05;
  EXPECT_NE(notes(scene).find("a roughness below 0.05 is taken for it"), std::string::npos);
  EXPECT_EQ(notes(scene).find("--min-roughness"), std::string::npos);
  scene.conventions.min_roughness = 0;
  scene.materials = {wavefront("sharp", 0.04, 1e9)};
  EXPECT_EQ(notes(scene).find("roughness"), std::string::npos) << "Ns is no roughness";
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
