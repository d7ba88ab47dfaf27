#pragma once

#include <string>
#include <vector>

#include "bench/shading/ways.hpp"
#include "reports/io/files.hpp"

/// A scene's materials as spheres: by the reference, as planned, and the difference.
namespace shadefit::shade {

/// The most spheres of a row.
inline constexpr std::size_t most_spheres = 11;

/// The subject of a sphere: materials with a lobe first, then skipped ones that are not black; a textured
/// material by quantiles of its powers.
struct Sphere {
  std::size_t material;
  double power;
};

std::vector<Sphere> spheres_of(const scene::Scene& scene, const scene::Plan& plan);

/// The picture "scene.png" before gnuplot has drawn it: its pixels and its script, which reads them.
std::vector<File> picture_files(const scene::Scene& scene, const scene::Plan& plan, const Kernels& kernels);

}  // namespace shadefit::shade
