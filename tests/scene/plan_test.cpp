#include "scene/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/lobe_error.hpp"

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

// What the largest shown error is, by brute force: every c and every factor up to the largest.
double largest_shown_error(double power, double factor, double offset) {
  double largest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double y = std::min(1.0, i * 0.01 / power);
    const double target = std::pow(1 - y, power), form = std::exp(-(power + offset) * y);
    for (int j = 1; j <= 100; ++j) {
      const double g = factor * j / 100;
      largest = std::max(largest, std::abs(std::min(g * form, 1.0) - std::min(g * target, 1.0)));
    }
  }
  return largest;
}

TEST(LobeError, IsTheLargestThatIsShown) {
  for (const double power : {1.0, 2.5, 16.0, 300.0, 1e5}) {
    for (const double factor : {0.01, 0.9, 4.0, 1000.0}) {
      for (const double offset : {0.0, 0.775}) {
        const double truth = largest_shown_error(power, factor, offset);
        const double proven = gaussian_error({power, factor}, offset, 0);
        const std::string where =
            std::to_string(power) + " " + std::to_string(factor) + " " + std::to_string(offset);
        EXPECT_GE(proven, truth) << where;
        // bounds are 2 % apart, and a hundred factors miss the worst by up to a percent of it
        EXPECT_LE(proven, 1.05 * truth) << where;
        EXPECT_LE(sampled_gaussian_error({power, factor}, offset), proven) << where;
        EXPECT_GE(sampled_gaussian_error({power, factor}, offset), 0.9 * truth) << where;
        EXPECT_LE(gaussian_error({power, factor}, offset, 2 * truth), 2 * truth * 1.02) << "enough is enough";
      }
    }
  }
}

TEST(LobeError, TheBestOffsetIsBest) {
  const std::vector<WeightedPower> lobes{{0, 1}, {8, 0.5}, {40, 1.5}};
  const double best = best_offset(lobes);
  const auto error = [&](double offset) {
    return std::max(sampled_gaussian_error(lobes[1], offset), sampled_gaussian_error(lobes[2], offset));
  };
  for (const double other : {best - 0.05, best + 0.05}) EXPECT_LT(error(best), error(other));
}

// Twenty materials, of which one shines, with a power of 1.
TEST(Plan, SkipsWhatIsBlack) {
  Scene scene;
  for (int i = 0; i < 19; ++i) scene.materials.push_back(wavefront("black " + std::to_string(i), 0, 50));
  scene.materials.push_back(wavefront("floor", 0.5, 1));
  const Plan plan = make_plan(scene, {});
  EXPECT_TRUE(plan.is_within());
  const Decision& specular = decision(plan, "specular");
  EXPECT_EQ(specular.verdict, Verdict::replace);
  EXPECT_EQ(specular.form, "for 1 of 20 materials");
  EXPECT_EQ(specular.reason, "skipped for 19 of 20 materials");
  EXPECT_EQ(plan.materials[0].reason, "black specular colour");
  EXPECT_FALSE(plan.materials[0].has_lobe);
  EXPECT_TRUE(plan.materials[19].has_lobe);
  EXPECT_EQ(decision(plan, "lobe").form, "c^1 by multiplications");
  EXPECT_EQ(decision(plan, "lobe").error, 0);
  EXPECT_EQ(decision(plan, "Fresnel").verdict, Verdict::skip);
  EXPECT_EQ(decision(plan, "normalisation").form, "0.375");
  EXPECT_EQ(decision(plan, "coloured F0").form, "one channel");
  EXPECT_EQ(decision(plan, "gloss decode").verdict, Verdict::skip);
  EXPECT_EQ(plan.fits_run, 0);
  // c 0.5 3/8 = 0.1/255
  EXPECT_NEAR(plan.materials[19].cutoff, 0.1 / 255 / 0.1875, 1e-9);
  EXPECT_LE(plan.materials[19].cutoff, 0.1 / 255 / 0.1875);
}

TEST(Plan, OfASceneWithoutSpecularIsEmpty) {
  Scene scene;
  scene.materials = {wavefront("black", 0, 50), material("unlit", 0.04, {{20, 1}})};
  scene.materials[1].is_unlit = true;
  const Plan plan = make_plan(scene, {});
  for (const Decision& d : plan.decisions) {
    EXPECT_EQ(d.verdict, Verdict::skip) << d.term;
    EXPECT_EQ(d.error, 0) << d.term;
  }
  EXPECT_EQ(plan.materials[1].reason, "unlit");
  EXPECT_EQ(plan.error, 0);
}

// A dull dielectric: 0.04 (n + 2)/8 is small, and a Gaussian is near enough; with the tolerance its form
// changes.
TEST(Plan, TakesTheCheapestFormThatIsNearEnough) {
  Scene scene;
  Material dull = wavefront("dull", 0.04, 0);
  dull.powers = {{10.5, 0.5}, {20.5, 0.5}};
  dull.power_texture = PowerTexture::roughness;
  scene.materials = {dull};
  const auto form = [&](double tolerance) {
    const Plan plan = make_plan(scene, {.tolerance = tolerance});
    EXPECT_TRUE(plan.is_within()) << tolerance;
    return decision(plan, "lobe").form;
  };
  EXPECT_EQ(form(1.0 / 64), "exp2(A c - A), A = n/ln 2");
  EXPECT_EQ(form(1.0 / 512), "exp2(A c - A), A = (n + x)/ln 2");
  EXPECT_EQ(form(1.0 / 4096), "exp2(n log2(c))");
  const Plan offset = make_plan(scene, {.tolerance = 1.0 / 512});
  EXPECT_EQ(offset.fits_run, 1);
  EXPECT_EQ(decision(offset, "offset x").verdict, Verdict::keep);
  EXPECT_EQ(make_plan(scene, {.tolerance = 1.0 / 64}).fits_run, 0) << "0 is near enough: nothing is fitted";
  // sixteen lights share the tolerance
  const Plan lights = make_plan(scene, {.tolerance = 1.0 / 255, .lights = 16});
  EXPECT_EQ(decision(lights, "lobe").form, "exp2(n log2(c))");
  EXPECT_TRUE(lights.is_within());
  EXPECT_EQ(decision(lights, "power").form, "for each pixel");
  EXPECT_EQ(decision(lights, "gloss decode").verdict, Verdict::keep);
}

TEST(Plan, KeepsFresnelWhereItRises) {
  Scene scene;
  scene.materials = {material("glass", 0.04, {{16, 1}})};
  const Plan plan = make_plan(scene, {});
  EXPECT_EQ(decision(plan, "Fresnel").verdict, Verdict::keep);
  scene.materials[0].f90 = {0.0402, 0.0402};
  EXPECT_EQ(decision(make_plan(scene, {}), "Fresnel").verdict, Verdict::skip);
  EXPECT_GT(decision(make_plan(scene, {}), "Fresnel").error, 0);
  scene.materials[0].f0[2] = {0.03, 0.03};
  EXPECT_EQ(decision(make_plan(scene, {}), "coloured F0").verdict, Verdict::keep);
}

TEST(Plan, OfAConstantLobe) {
  Scene scene;
  scene.materials = {wavefront("rough", 1, 0)};
  const Plan plan = make_plan(scene, {});
  EXPECT_EQ(decision(plan, "lobe").verdict, Verdict::skip);
  EXPECT_EQ(decision(plan, "lobe").reason, "every power is 0: a constant");
  EXPECT_EQ(decision(plan, "culling").verdict, Verdict::skip);
  // 0.001 (0 + 2)/8 is less than a code
  scene.materials = {wavefront("faint", 0.001, 0)};
  const Plan faint = make_plan(scene, {});
  EXPECT_FALSE(faint.materials[0].has_lobe);
  EXPECT_EQ(faint.materials[0].reason, "at most 0.00025 of a light");
  EXPECT_EQ(faint.error, 0.00025);
}

// The error of the whole, by brute force: a planned Gaussian beside the shading as it is written.
TEST(Plan, KeepsItsPromise) {
  Scene scene;
  scene.materials = {wavefront("a", 0.04, 10.5), wavefront("b", 0.03, 33.25)};
  const Plan plan = make_plan(scene, {.tolerance = 1.0 / 512});
  ASSERT_EQ(decision(plan, "lobe").form, "exp2(A c - A), A = (n + x)/ln 2");
  const double offset = std::stod(decision(plan, "offset x").form.substr(4));
  double largest = 0;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const double power = scene.materials[m].powers[0].power, factor = plan.materials[m].factor;
    for (int i = 0; i <= 10000; ++i) {
      const double c = i / 10000.0;
      const double shown = std::min(1.0, factor * std::pow(c, power));
      const double planned =
          c < plan.materials[m].cutoff ? 0 : std::min(1.0, factor * std::exp((power + offset) * (c - 1)));
      largest = std::max(largest, std::abs(planned - shown));
    }
  }
  EXPECT_LE(largest, plan.error);
  EXPECT_GE(largest, 0.3 * plan.error) << "and it is no idle one";
}

}  // namespace
}  // namespace shadefit::scene
