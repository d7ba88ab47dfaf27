#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bench/forms/kernel.hpp"
#include "scene/plan/lobe_form.hpp"

/// The specular term of many samples at a time, F (n + 2)/8 lobe (n.l), by the reference's
/// formulas in double and in float, by the published constants, and as a plan has it. A sample is a pixel
/// under one light; its cosines are given, because geometry is the same however the term is computed.
namespace shadefit::shade {

/// Pixels of a tile: neighbours of one material. No width of the registers leaves a rest of them.
inline constexpr std::size_t tile_pixels = 64;

/// The most lights of one tile.
inline constexpr std::size_t most_lights = 8;

/// Tiles of one material and where their results go. Sums are over the lights of a pixel.
template <class Real>
struct Block {
  std::size_t tiles = 0, lights = 1;
  /// n.h, l.h and n.l of tile t, light l and pixel p, at (t lights + l) tile_pixels + p.
  const Real *n_dot_h = nullptr, *l_dot_h = nullptr, *n_dot_l = nullptr;
  /// The roughness alpha of each pixel, tile by tile; null where the power is the material's.
  const Real* alpha = nullptr;
  /// Red, green, blue, tile by tile. A plan with one channel writes the first alone.
  std::array<Real*, 3> out = {};
};

/// A material with all of its terms.
template <class Real>
struct FullMaterial {
  std::array<Real, 3> f0, f90;
  Real power;  ///< where pixels have none of their own
};

/// A material as a plan has it: its constants, computed once.
struct PlannedMaterial {
  scene::LobeKind kind = scene::LobeKind::power;
  bool is_fused = false;
  int whole = 0;        ///< of `multiplied`
  int exp2_degree = 0;  ///< 0 where there is no exp2
  /// Slopes of the exponent; times n + x unless the power is the pixel's.
  std::array<float, 4> slopes = {};
  int slope_count = 0;
  float offset = 0;  ///< x, where the power is the pixel's
  float power = 0;   ///< n of `power`, where it is the material's
  bool is_power_of_pixel = false, has_fresnel = true, is_coloured = true;
  std::array<float, 3> f0 = {}, f90 = {};  ///< times (n + 2)/8 unless the power is the pixel's
  float cutoff = 0;                        ///< of n.h
  float least_exponent = 0;                ///< of the lobe, where the power is the pixel's
};

/// Every term.
template <class Real>
using FullKernel = void (*)(const Block<Real>&, const FullMaterial<Real>&);
/// Returns how many samples were culled.
using PlannedKernel = std::size_t (*)(const Block<float>&, const PlannedMaterial&);

struct Kernels {
  forms::Width width;
  FullKernel<double> truth;  ///< the reference's formulas
  FullKernel<float> reference, published;
  PlannedKernel planned;
};

/// The kernels of each width that this machine has, narrowest first. Every x86-64 has SSE2.
std::vector<Kernels> kernels_here();

}  // namespace shadefit::shade
