#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "approx/exp2_polynomial.hpp"
#include "approx/microfacet.hpp"
#include "bench/shading/geometry.hpp"
#include "bench/shading/kernels/full_terms.hpp"
#include "bench/shading/shaded_scene.hpp"
#include "bench/shading/workload.hpp"

namespace shadefit::shade {
namespace {

/// The last digits of floats that are summed, and multiplied in another order.
constexpr double float_rounding = 2e-6;

/// A block of the sphere with powers that differ from tile to tile.
struct Scenery {
  Cosines cosines = std::move(sphere_blocks(1, 20, 3).front());
  std::vector<float> alpha;
  std::vector<double> wide_alpha;
  Results<float> results{20};
  Results<double> wide_results{20};

  Scenery() {
    for (std::size_t i = 0; i < 20 * tile_pixels; ++i)
      alpha.push_back(static_cast<float>(1.0 / (1.0 + 0.2 * static_cast<double>(i / tile_pixels))));
    wide_alpha.assign(alpha.begin(), alpha.end());
  }
  Block<float> block(bool is_power_of_pixel) {
    Block<float> made = cosines.block<float>();
    made.alpha = is_power_of_pixel ? alpha.data() : nullptr;
    made.out = results.out();
    return made;
  }
  Block<double> wide_block(bool is_power_of_pixel) {
    Block<double> made = cosines.block<double>();
    made.alpha = is_power_of_pixel ? wide_alpha.data() : nullptr;
    made.out = wide_results.out();
    return made;
  }
};

/// The lobe of a plan, one sample at a time, with the library's exp2.
double lobe_of(const PlannedMaterial& m, double c, double n) {
  std::vector<double> slopes(m.slopes.begin(), m.slopes.begin() + m.slope_count);
  const auto offset = static_cast<double>(m.offset);
  switch (m.kind) {
    case scene::LobeKind::constant:
      return 1;
    case scene::LobeKind::multiplied:
      return std::pow(c, m.whole);
    case scene::LobeKind::power:
      return std::pow(c, m.is_power_of_pixel ? n : static_cast<double>(m.power));
    case scene::LobeKind::exponential:
      break;
  }
  return m.is_power_of_pixel ? sloped_lobe(c, n + offset, slopes) : sloped_lobe(c, slopes);
}

/// A plan's result for a pixel in a channel, summed over its lights, without culling.
double shown_of(const PlannedMaterial& m, const Block<float>& block, std::size_t pixel, std::size_t channel) {
  double sum = 0;
  const std::size_t tile = pixel / tile_pixels, i = m.is_coloured ? channel : 0;
  const double n = block.alpha == nullptr ? 0 : blinn_phong_exponent(static_cast<double>(block.alpha[pixel]));
  const double normalisation = m.is_power_of_pixel ? game_normalisation(n) : 1;
  for (std::size_t light = 0; light < block.lights; ++light) {
    const std::size_t at = (tile * block.lights + light) * tile_pixels + pixel % tile_pixels;
    const auto f0 = static_cast<double>(m.f0[i]), f90 = static_cast<double>(m.f90[i]);
    const double weight = m.has_fresnel ? schlick_weight(static_cast<double>(block.l_dot_h[at])) : 0;
    sum += shown_specular(reflectance_between(f0, f90, weight), normalisation,
                          lobe_of(m, static_cast<double>(block.n_dot_h[at]), n),
                          static_cast<double>(block.n_dot_l[at]));
  }
  return sum;
}

/// Every form that a plan may have, with every term and without.
std::vector<PlannedMaterial> all_forms() {
  std::vector<PlannedMaterial> all;
  const auto add = [&](PlannedMaterial m) {
    for (const int flags : {0, 1, 2, 3}) {
      m.has_fresnel = (flags & 1) != 0;
      m.is_coloured = (flags & 2) != 0;
      m.f0 = {0.4F, 0.6F, 0.1F};
      m.f90 = {2, 3, 0.5F};
      m.cutoff = 0;
      m.least_exponent = -1000;
      all.push_back(m);
    }
  };
  add({.kind = scene::LobeKind::constant});
  for (const int whole : {1, 2, 5, 7, 64, 100}) add({.kind = scene::LobeKind::multiplied, .whole = whole});
  for (int degree = least_exp2_degree; degree <= largest_exp2_degree; ++degree) {
    for (const bool is_power_of_pixel : {false, true}) {
      const float n = is_power_of_pixel ? 1 : 20;
      PlannedMaterial m{.exp2_degree = degree, .power = n, .is_power_of_pixel = is_power_of_pixel};
      add(m);
      m.kind = scene::LobeKind::exponential;
      m.offset = 0.375F;
      m.slopes = {1.4427F * n, -0.7213F * n, 0.4809F * n, -0.3607F * n};
      for (m.slope_count = 1; m.slope_count <= 4; ++m.slope_count) {
        add(m);
        if (m.slope_count > 1) continue;
        m.is_fused = true;
        add(m);
        m.is_fused = false;
      }
    }
  }
  return all;
}

TEST(PlannedKernels, AgreeWithOneSampleAtATime) {
  Scenery scenery;
  for (const Kernels& kernels : kernels_here()) {
    for (const PlannedMaterial& m : all_forms()) {
      scenery.results.clear();
      const Block<float> block = scenery.block(m.is_power_of_pixel);
      EXPECT_EQ(kernels.planned(block, m), 0U);
      // exp2 by a polynomial is off by what its record says of each light
      double allowed = 1e-5 * static_cast<double>(block.lights);
      if (m.exp2_degree > 0)
        allowed += std::stod(std::string(exp2_for_float[static_cast<std::size_t>(m.exp2_degree) - 2].bound)) *
                   static_cast<double>(block.lights);
      double worst = 0;
      for (std::size_t channel = 0; channel < (m.is_coloured ? 3U : 1U); ++channel) {
        for (std::size_t pixel = 0; pixel < block.tiles * tile_pixels; ++pixel)
          worst = std::max(worst, std::abs(static_cast<double>(scenery.results.channel(channel)[pixel]) -
                                           shown_of(m, block, pixel, channel)));
      }
      EXPECT_LE(worst, allowed) << forms::name(kernels.width) << ": kind " << static_cast<int>(m.kind)
                                << ", degree " << m.exp2_degree << ", slopes " << m.slope_count << ", pixel "
                                << m.is_power_of_pixel << ", Fresnel " << m.has_fresnel << ", coloured "
                                << m.is_coloured;
    }
  }
}

TEST(PlannedKernels, CullWhatIsBelowTheCutoffAndNothingElse) {
  Scenery scenery;
  PlannedMaterial m{
      .kind = scene::LobeKind::multiplied, .whole = 1, .has_fresnel = false, .is_coloured = false};
  m.f0 = {1, 1, 1};
  m.cutoff = 0.8F;
  for (const Kernels& kernels : kernels_here()) {
    scenery.results.clear();
    Block<float> block = scenery.block(false);
    const std::size_t culled = kernels.planned(block, m);
    std::size_t below = 0;
    for (std::size_t i = 0; i < block.tiles * block.lights * tile_pixels; ++i)
      below += block.n_dot_h[i] <= m.cutoff ? 1U : 0U;
    EXPECT_GT(culled, 0U);
    EXPECT_LE(culled, below) << "a register goes as a whole";
    for (std::size_t pixel = 0; pixel < block.tiles * tile_pixels; ++pixel) {
      // each light loses at most its value at the cut-off
      const double whole = shown_of(m, block, pixel, 0);
      const auto shown = static_cast<double>(scenery.results.channel(0)[pixel]);
      ASSERT_LE(shown, whole + float_rounding);
      ASSERT_GE(shown, whole - 3 * 0.8 - float_rounding);
    }
  }
}

TEST(PlannedKernels, ShowNumbersWhereTheHalfVectorIsAtTheHorizon) {
  Cosines cosines(1, 1);
  for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel)
    cosines.set(0, 0, pixel, {.n_dot_h = pixel % 2 == 0 ? 0.0 : 0.5, .l_dot_h = 0, .n_dot_l = 0});
  const std::vector<float> rough(tile_pixels, 1);
  Results<float> results(1);
  Block<float> block = cosines.block<float>();
  block.alpha = rough.data();
  block.out = results.out();
  for (const Kernels& kernels : kernels_here()) {
    for (PlannedMaterial m : all_forms()) {
      m.power = 0;  // and so has a roughness of 1
      kernels.planned(block, m);
      for (const float value : results.channel(0)) ASSERT_EQ(value, 0) << "kind " << static_cast<int>(m.kind);
    }
  }
}

TEST(ReferenceKernels, AreTheFormulaInLongDouble) {
  Scenery scenery;
  const FullMaterial<double> m{{0.04, 0.5, 0.9}, {1, 1, 0.95}, 73.5};
  for (const Kernels& kernels : kernels_here()) {
    for (const bool is_power_of_pixel : {false, true}) {
      const Block<double> block = scenery.wide_block(is_power_of_pixel);
      kernels.truth(block, m);
      for (std::size_t pixel = 0; pixel < block.tiles * tile_pixels; ++pixel) {
        using Wide = long double;
        const Wide n = is_power_of_pixel ? blinn_phong_exponent(Wide(block.alpha[pixel])) : Wide(m.power);
        std::array<Wide, 3> sum{};
        for (std::size_t light = 0; light < block.lights; ++light) {
          const std::size_t at =
              (pixel / tile_pixels * block.lights + light) * tile_pixels + pixel % tile_pixels;
          const auto shown = specular<ReferenceForms>(
              Wide(block.n_dot_h[at]), Wide(block.l_dot_h[at]), Wide(block.n_dot_l[at]),
              ReferenceForms::prepared(n), {m.f0[0], m.f0[1], m.f0[2]}, {m.f90[0], m.f90[1], m.f90[2]});
          for (std::size_t i = 0; i < 3; ++i) sum[i] += shown[i];
        }
        for (std::size_t i = 0; i < 3; ++i)
          ASSERT_NEAR(scenery.wide_results.channel(i)[pixel], static_cast<double>(sum[i]), 1e-9);
      }
    }
  }
}

TEST(PublishedKernels, AreTheirFormulaInDouble) {
  Scenery scenery;
  const FullMaterial<double> m{{0.04, 0.5, 0.9}, {1, 1, 0.95}, 20};
  for (const Kernels& kernels : kernels_here()) {
    const Block<float> block = scenery.block(false);
    kernels.published(block, narrowed(m));
    for (std::size_t pixel = 0; pixel < block.tiles * tile_pixels; ++pixel) {
      double sum = 0;
      for (std::size_t light = 0; light < block.lights; ++light) {
        const std::size_t at =
            (pixel / tile_pixels * block.lights + light) * tile_pixels + pixel % tile_pixels;
        sum += specular<PublishedForms>(
            static_cast<double>(block.n_dot_h[at]), static_cast<double>(block.l_dot_h[at]),
            static_cast<double>(block.n_dot_l[at]), PublishedForms::prepared(20.0), m.f0, m.f90)[1];
      }
      ASSERT_NEAR(static_cast<double>(scenery.results.channel(1)[pixel]), sum, 1e-5);
    }
  }
}

}  // namespace
}  // namespace shadefit::shade
