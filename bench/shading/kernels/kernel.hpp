#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bench/forms/kernel.hpp"
#include "scene/plan/lobe_form.hpp"

/// The specular term of many samples at a time, F (n + 2)/8 lobe (n.l): by the reference's formulas in double
/// and in float, by the published constants, and by a plan. A sample is a pixel under one light. Its cosines
/// are given, because geometry is the same for all ways.
namespace shadefit::shade {

/// Pixels of a tile: neighbours of one material, a multiple of every register width.
inline constexpr std::size_t tile_pixels = 64;

/// The most lights of one tile.
inline constexpr std::size_t most_lights = 8;

/// Tiles of one material, and the place of their results: sums over the lights of a pixel.
template <class Real>
struct Block {
  std::size_t tiles = 0, lights = 1;
  /// n.h, l.h and n.l of tile t, light l and pixel p, at (t lights + l) tile_pixels + p.
  const Real *n_dot_h = nullptr, *l_dot_h = nullptr, *n_dot_l = nullptr;
  /// The roughness alpha of each pixel, tile by tile; null if the power belongs to the material.
  const Real* alpha = nullptr;
  /// Red, green, blue, tile by tile. A plan with one channel writes only the first.
  std::array<Real*, 3> out = {};
};

/// A material with all of its terms.
template <class Real>
struct FullMaterial {
  std::array<Real, 3> f0, f90;
  Real power;  ///< if pixels have no own power
};

/// A material of a plan: its constants, computed once.
struct PlannedMaterial {
  scene::LobeKind kind = scene::LobeKind::power;
  bool is_fused = false;
  int whole = 0;        ///< of `multiplied`
  int exp2_degree = 0;  ///< 0 without exp2
  /// Slopes of the exponent; times n + x unless the power is the pixel's.
  std::array<float, 4> slopes = {};
  int slope_count = 0;
  float offset = 0;  ///< x, if the power belongs to the pixel
  float power = 0;   ///< n of `power`, if it belongs to the material
  bool is_power_of_pixel = false, has_fresnel = true, is_coloured = true;
  std::array<float, 3> f0 = {}, f90 = {};  ///< times (n + 2)/8 unless the power is the pixel's
  float cutoff = 0;                        ///< of n.h
  float least_exponent = 0;                ///< of the lobe, if the power belongs to the pixel
};

/// Every term.
template <class Real>
using FullKernel = void (*)(const Block<Real>&, const FullMaterial<Real>&);
/// Returns the number of culled samples.
using PlannedKernel = std::size_t (*)(const Block<float>&, const PlannedMaterial&);

struct Kernels {
  forms::Width width;
  FullKernel<double> truth;  ///< the reference's formulas
  FullKernel<float> reference, published;
  PlannedKernel planned;
};

/// The kernels of each width, each in its own unit, compiled with its instructions.
struct KernelUnits {
  static const Kernels sse2, avx2, avx512;
};

/// The kernels of each width that this machine has, narrowest first. Every x86-64 has SSE2.
std::vector<Kernels> kernels_here();

}  // namespace shadefit::shade
