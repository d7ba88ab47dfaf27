#include "scene/plan/rounding_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "approx/shading.hpp"
#include "fit/scalars/half.hpp"

namespace shadefit::scene {
namespace {

/// A light of what floats or halves make of a lobe, all of it in that format: A c - A or slopes, the constant
/// reflectance and normalisation, n.l.
template <class T>
double measured_rounding(const LobeForm& form, double power, double reflectance) {
  const auto rounded = [](double x) { return static_cast<T>(x); };
  LobeConstants<T> constants;
  LobeConstants<double> exact;
  for (const double slope : form.slopes) {
    constants.slopes.push_back(rounded((power + form.offset) * slope));
    exact.slopes.push_back((power + form.offset) * slope);
  }
  const double normalisation = (power + 2) / 8;
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const T c = rounded(1 - i * 0.001 / power);
    if (!(static_cast<double>(c) >= 0)) break;
    for (const double light : {1.0, 0.71, 0.37}) {
      const T lobe = planned_lobe(form, c, constants);
      const auto shown = static_cast<double>(
          shown_specular(rounded(reflectance), rounded(normalisation), lobe, rounded(light)));
      const double truth = shown_specular(reflectance, normalisation,
                                          planned_lobe(form, static_cast<double>(c), exact), light);
      largest = std::max(largest, std::abs(shown - truth));
    }
  }
  return largest;
}

Lobes lobes_of_power(double power, double reflectance) {
  return {.all = {WeightedPower{{power, power}, reflectance * (power + 2) / 8}},
          .textures = {PowerTexture::none}};
}

TEST(RoundingError, IsNotExceeded) {
  for (const bool is_fused : {false, true}) {
    for (const double power : {8.0, 77.7, 300.5, 1e4}) {
      for (const double reflectance : {0.04, 0.3, 1.0}) {
        const LobeForm form{
            .kind = LobeKind::exponential, .offset = 0.7, .slopes = {natural_slope}, .is_fused = is_fused};
        const Lobes lobes = lobes_of_power(power, reflectance);
        const auto bound = [&](PixelPrecision precision) {
          return rounding_error({form, lobes, false, false}, precision, ShownScale::linear);
        };
        const std::string where = std::to_string(power) + " " + std::to_string(reflectance);
        const double in_float = measured_rounding<float>(form, power, reflectance);
        EXPECT_LE(in_float, bound(PixelPrecision::float32)) << where;
        EXPECT_LE(measured_rounding<Eigen::half>(form, power, reflectance), bound(PixelPrecision::float16))
            << where;
        EXPECT_GE(in_float, 0.04 * bound(PixelPrecision::float32))
            << where << ": the bound is at most 25 times too large";
      }
    }
  }
}

TEST(RoundingError, CountsWhatThereIs) {
  const LobeForm gaussian{.kind = LobeKind::exponential, .slopes = {natural_slope}};
  const Lobes lobes = lobes_of_power(20, 0.04);
  const auto in_float = [&](const RoundedShading& shading) {
    return rounding_error(shading, PixelPrecision::float32, ShownScale::linear);
  };
  const double plain = in_float({gaussian, lobes, false, false});
  EXPECT_GT(in_float({gaussian, lobes, true, false}), plain);
  Lobes textured = lobes;
  textured.textures = {PowerTexture::roughness};
  const double of_roughness = in_float({gaussian, textured, false, false});
  EXPECT_GT(of_roughness, plain);
  EXPECT_GT(in_float({gaussian, textured, false, true}), of_roughness);
  // slopes that cancel, 1.58 - 0.34 y: by 1.55 at y = 1
  const LobeForm cancelling{.kind = LobeKind::exponential, .slopes = {1.58, 0.34}};
  const LobeForm alike{.kind = LobeKind::exponential, .slopes = {1.58, -0.34}};
  EXPECT_GT(in_float({cancelling, lobes, false, false}), in_float({alike, lobes, false, false}));
  EXPECT_GT(rounding_error({gaussian, lobes, false, false}, PixelPrecision::float32, ShownScale::codes),
            100 * plain);
  // no half is 1e5
  EXPECT_EQ(rounding_error({gaussian, lobes_of_power(1e5, 0.04), false, false}, PixelPrecision::float16,
                           ShownScale::linear),
            1);
  EXPECT_EQ(name(PixelPrecision::float16), "half");
}

}  // namespace
}  // namespace shadefit::scene
