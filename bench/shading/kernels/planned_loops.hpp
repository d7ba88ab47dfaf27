#pragma once

#include <cstddef>
#include <cstdint>

#include "approx/exp2_polynomial.hpp"
#include "approx/fresnel.hpp"
#include "approx/microfacet.hpp"
#include "bench/forms/batch_lanes.hpp"
#include "bench/shading/kernels/kernel.hpp"
#include "bench/shading/kernels/lobe_exponents.hpp"

/// The loops of the planned way. The first selects the registers that a light can affect, the second computes
/// the exponents of their lobes, the third their values, each for several tiles. Culled registers are removed
/// between the loops, so that no loop has a branch that depends on a pixel.
namespace shadefit::shade {

/// The samples of one pass: they fit into the first cache together with their cosines.
inline constexpr std::size_t most_in_work = 1024;
static_assert(most_in_work >= tile_pixels * most_lights);

/// The data of one pass, which begins at a tile of a block. Indices count from that tile.
template <class S>
struct Work {
  static constexpr std::size_t most = most_in_work / forms::Lanes<S>::size;
  std::size_t tiles;
  std::size_t count;                                         ///< of kept registers
  std::uint16_t samples[most], pixels[most];                 ///< the begin of each
  float exponents[most_in_work];                             ///< of each kept register, or its lobe
  float powers[most_in_work], normalisations[most_in_work];  ///< of each pixel
};

/// Keeps the registers in which any n.h is above the cut-off.
template <class S>
void keep_above_cutoff(Work<S>& work, const float* n_dot_h, std::size_t lights, float cutoff) {
  using L = forms::Lanes<S>;
  const S least = L::of(cutoff);
  std::size_t count = 0, sample = 0;
  for (std::size_t tile = 0; tile < work.tiles; ++tile) {
    for (std::size_t light = 0; light < lights; ++light) {
      for (std::size_t p = 0; p < tile_pixels; p += L::size, sample += L::size) {
        work.samples[count] = static_cast<std::uint16_t>(sample);
        work.pixels[count] = static_cast<std::uint16_t>(tile * tile_pixels + p);
        count += xsimd::any(less(least, L::load(n_dot_h + sample))) ? 1U : 0U;
      }
    }
  }
  work.count = count;
}

template <class S>
void decode_powers(Work<S>& work, const float* alpha) {
  using L = forms::Lanes<S>;
  for (std::size_t p = 0; p < work.tiles * tile_pixels; p += L::size) {
    const S power = blinn_phong_exponent(L::load(alpha + p));
    L::store(power, work.powers + p);
    L::store(game_normalisation(power), work.normalisations + p);
  }
}

/// The exponents of the kept registers. If the power belongs to the pixel, only registers with an exponent
/// above the least are kept.
template <class S, class Exponent>
void find_exponents(Work<S>& work, const float* n_dot_h, const PlannedMaterial& m) {
  using L = forms::Lanes<S>;
  const Exponent exponent(m);
  const std::size_t kept = work.count;
  if (!m.is_power_of_pixel) {
    for (std::size_t k = 0; k < kept; ++k)
      L::store(exponent(L::load(n_dot_h + work.samples[k])), work.exponents + k * L::size);
    return;
  }
  const S least = L::of(m.least_exponent);
  std::size_t count = 0;
  for (std::size_t k = 0; k < kept; ++k) {
    const std::uint16_t sample = work.samples[k], pixel = work.pixels[k];
    const S found = exponent(L::load(n_dot_h + sample), L::load(work.powers + pixel));
    work.samples[count] = sample;
    work.pixels[count] = pixel;
    L::store(found, work.exponents + count * L::size);
    count += xsimd::any(less(least, found)) ? 1U : 0U;
  }
  work.count = count;
}

/// c^whole by repeated squaring, the multiplications of `power` in their order, each for all kept registers.
template <class S>
void multiply_lobes(Work<S>& work, const float* n_dot_h, int whole) {
  using L = forms::Lanes<S>;
  const std::size_t count = work.count;
  for (std::size_t k = 0; k < count; ++k)
    L::store(L::load(n_dot_h + work.samples[k]), work.exponents + k * L::size);
  int bit = 1;
  while (bit <= whole / 2) bit *= 2;
  for (bit /= 2; bit > 0; bit /= 2) {
    const bool is_odd = (whole & bit) != 0;
    for (std::size_t k = 0; k < count; ++k) {
      float* const at = work.exponents + k * L::size;
      const S half = L::load(at);
      const S even = half * half;
      L::store(is_odd ? S(even * L::load(n_dot_h + work.samples[k])) : even, at);
    }
  }
}

template <class S>
void find_lobes(Work<S>& work, const float* n_dot_h, const PlannedMaterial& m) {
  switch (m.kind) {
    case scene::LobeKind::constant:
      for (std::size_t k = 0; k < work.count; ++k)
        forms::Lanes<S>::store(integer<S>(1), work.exponents + k * forms::Lanes<S>::size);
      break;
    case scene::LobeKind::multiplied:
      multiply_lobes(work, n_dot_h, m.whole);
      break;
    case scene::LobeKind::exponential:
      if (m.is_fused) {
        find_exponents<S, FusedExponent<S>>(work, n_dot_h, m);
      } else if (m.slope_count == 1) {
        find_exponents<S, SlopedExponent<S, 1>>(work, n_dot_h, m);
      } else if (m.slope_count == 2) {
        find_exponents<S, SlopedExponent<S, 2>>(work, n_dot_h, m);
      } else if (m.slope_count == 3) {
        find_exponents<S, SlopedExponent<S, 3>>(work, n_dot_h, m);
      } else {
        find_exponents<S, SlopedExponent<S, 4>>(work, n_dot_h, m);
      }
      break;
    case scene::LobeKind::power:
      find_exponents<S, LogarithmExponent<S>>(work, n_dot_h, m);
      break;
  }
}

/// Adds the kept registers to their pixels. Degree 0: the lobe is already computed.
template <class S, int degree, bool is_power_of_pixel, bool has_fresnel, std::size_t channels>
void add_shown(const Work<S>& work, const Block<float>& block, const PlannedMaterial& m) {
  using L = forms::Lanes<S>;
  const float *const n_dot_h = block.n_dot_h, *const l_dot_h = block.l_dot_h, *const n_dot_l = block.n_dot_l;
  S f0[channels], f90[channels];
  float* out[channels];
  for (std::size_t i = 0; i < channels; ++i) {
    f0[i] = L::of(m.f0.data()[i]);
    f90[i] = L::of(m.f90.data()[i]);
    out[i] = block.out.data()[i];
  }
  const std::size_t count = work.count;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t sample = work.samples[k], pixel = work.pixels[k];
    S lobe = L::load(work.exponents + k * L::size);
    if constexpr (degree > 0) lobe = exp2_polynomial<Exp2Choice<degree, float>>(lobe);
    // If the power belongs to the material, F0 and F90 include the normalisation.
    if constexpr (is_power_of_pixel) lobe = L::load(work.normalisations + pixel) * lobe;
    const S light = seen_light(L::load(n_dot_l + sample), L::load(n_dot_h + sample));
    S weight = integer<S>(0);
    if constexpr (has_fresnel) weight = schlick_weight(L::load(l_dot_h + sample));
    for (std::size_t i = 0; i < channels; ++i) {
      S reflectance = f0[i];
      if constexpr (has_fresnel) reflectance = reflectance_between(f0[i], f90[i], weight);
      const S shown = shown_specular(reflectance, integer<S>(1), lobe, light);
      L::store(L::load(out[i] + pixel) + shown, out[i] + pixel);
    }
  }
}

template <class S, int degree, bool is_power_of_pixel>
void add_shown_of(const Work<S>& work, const Block<float>& block, const PlannedMaterial& m) {
  if (m.has_fresnel && m.is_coloured) {
    add_shown<S, degree, is_power_of_pixel, true, 3>(work, block, m);
  } else if (m.has_fresnel) {
    add_shown<S, degree, is_power_of_pixel, true, 1>(work, block, m);
  } else if (m.is_coloured) {
    add_shown<S, degree, is_power_of_pixel, false, 3>(work, block, m);
  } else {
    add_shown<S, degree, is_power_of_pixel, false, 1>(work, block, m);
  }
}

template <class S, int degree>
void add_shown_by_power(const Work<S>& work, const Block<float>& block, const PlannedMaterial& m) {
  m.is_power_of_pixel ? add_shown_of<S, degree, true>(work, block, m)
                      : add_shown_of<S, degree, false>(work, block, m);
}

template <class S>
void add_shown_by_degree(const Work<S>& work, const Block<float>& block, const PlannedMaterial& m) {
  switch (m.exp2_degree) {
    case 0:
      return add_shown_by_power<S, 0>(work, block, m);
    case 2:
      return add_shown_by_power<S, 2>(work, block, m);
    case 3:
      return add_shown_by_power<S, 3>(work, block, m);
    case 4:
      return add_shown_by_power<S, 4>(work, block, m);
    case 5:
      return add_shown_by_power<S, 5>(work, block, m);
    default:
      return add_shown_by_power<S, 6>(work, block, m);
  }
}

template <class S>
std::size_t shade_as_planned(const Block<float>& all, const PlannedMaterial& m) {
  using L = forms::Lanes<S>;
  const std::size_t samples_of_tile = all.lights * tile_pixels;
  const std::size_t tiles_at_once = most_in_work / samples_of_tile;
  const std::size_t channels = m.is_coloured ? 3 : 1;
  Work<S> work;
  Block<float> block = all;
  std::size_t culled = 0;
  for (std::size_t first = 0; first < all.tiles; first += tiles_at_once) {
    work.tiles = all.tiles - first < tiles_at_once ? all.tiles - first : tiles_at_once;
    const std::size_t pixels = work.tiles * tile_pixels;
    for (std::size_t i = 0; i < channels; ++i) {
      for (std::size_t p = 0; p < pixels; p += L::size) L::store(integer<S>(0), block.out.data()[i] + p);
    }
    keep_above_cutoff(work, block.n_dot_h, all.lights, m.cutoff);
    if (m.is_power_of_pixel) decode_powers(work, block.alpha);
    find_lobes(work, block.n_dot_h, m);
    culled += pixels * all.lights - work.count * L::size;
    add_shown_by_degree(work, block, m);
    block.n_dot_h += pixels * all.lights;
    block.l_dot_h += pixels * all.lights;
    block.n_dot_l += pixels * all.lights;
    if (block.alpha != nullptr) block.alpha += pixels;
    for (std::size_t i = 0; i < channels; ++i) block.out.data()[i] += pixels;
  }
  return culled;
}

}  // namespace shadefit::shade
