#pragma once

#include <array>
#include <cstddef>

#include "approx/microfacet.hpp"
#include "bench/forms/lanes.hpp"
#include "bench/shading/kernels/full_terms.hpp"
#include "bench/shading/kernels/kernel.hpp"

/// The loop of the ways that compute every term.
namespace shadefit::shade {

template <class Forms, class S>
void shade_with_all_terms(const Block<typename forms::Lanes<S>::Real>& block,
                          const FullMaterial<typename forms::Lanes<S>::Real>& material) {
  using L = forms::Lanes<S>;
  using Real = typename L::Real;
  std::array<S, 3> f0, f90;
  for (std::size_t i = 0; i < 3; ++i) {
    f0[i] = L::of(material.f0.data()[i]);
    f90[i] = L::of(material.f90.data()[i]);
  }
  const PreparedPower<S> of_material = Forms::prepared(L::of(material.power));
  const std::size_t lights = block.lights;
  const Real* const alpha = block.alpha;
  Real *const red = block.out.data()[0], *const green = block.out.data()[1],
              *const blue = block.out.data()[2];
  for (std::size_t tile = 0; tile < block.tiles; ++tile) {
    for (std::size_t p = 0; p < tile_pixels; p += L::size) {
      const std::size_t pixel = tile * tile_pixels + p;
      const PreparedPower<S> power =
          alpha == nullptr ? of_material : Forms::prepared(S(blinn_phong_exponent(L::load(alpha + pixel))));
      std::array<S, 3> sum{L::of(Real(0)), L::of(Real(0)), L::of(Real(0))};
      for (std::size_t light = 0; light < lights; ++light) {
        const std::size_t at = (tile * lights + light) * tile_pixels + p;
        const std::array<S, 3> shown =
            specular<Forms>(L::load(block.n_dot_h + at), L::load(block.l_dot_h + at),
                            L::load(block.n_dot_l + at), power, f0, f90);
        for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + shown[i];
      }
      L::store(sum[0], red + pixel);
      L::store(sum[1], green + pixel);
      L::store(sum[2], blue + pixel);
    }
  }
}

}  // namespace shadefit::shade
