#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "bench/shading/kernels/kernel.hpp"

/// The geometry: a sphere seen from nearby, lit from all directions on the viewer's side.
namespace shadefit::shade {

/// The cosines of one sample.
struct Sample {
  double n_dot_h, l_dot_h, n_dot_l;
};

/// For a point of the unit sphere around the origin, seen from (0, 0, `eye_distance`), and the direction of a
/// light.
Sample sample_of(const std::array<double, 3>& normal, const std::array<double, 3>& light);

/// Radii from the sphere's middle to the eye: near enough that the view direction, and so l.h, varies as in a
/// room.
inline constexpr double eye_distance = 4;

/// The cosines of a block's samples, in the layout of `Block`: each is a float, stored as float and as
/// double, so that all ways get the same inputs.
class Cosines {
 public:
  /// Room for tiles under so many lights each.
  Cosines(std::size_t tiles, std::size_t lights);

  std::size_t tiles() const { return tiles_; }
  std::size_t lights() const { return lights_; }
  void set(std::size_t tile, std::size_t light, std::size_t pixel, const Sample& sample);

  /// A block of all tiles, without powers or results.
  template <class Real>
  Block<Real> block() const {
    const auto& [n_dot_h, l_dot_h, n_dot_l] = std::get<Channels<Real>>(cosines_);
    return {tiles_, lights_, n_dot_h.data(), l_dot_h.data(), n_dot_l.data(), nullptr, {}};
  }

 private:
  std::size_t tiles_, lights_;
  template <class Real>
  using Channels = std::array<std::vector<Real>, 3>;
  std::tuple<Channels<float>, Channels<double>> cosines_;  ///< n.h, l.h and n.l
};

/// Blocks of lit and visible tiles, spread evenly over the sphere, the same in every run.
std::vector<Cosines> sphere_blocks(std::size_t blocks, std::size_t tiles, std::size_t lights);

}  // namespace shadefit::shade
