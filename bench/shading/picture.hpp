#pragma once

#include <string>
#include <vector>

#include "bench/shading/ways.hpp"
#include "reports/io/files.hpp"

/// A scene's materials as spheres: by the reference, by other ways, and the difference of the last.
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

/// A row of the picture.
struct ShownWay {
  std::string name;
  Way way;
};

/// The pixels of a sphere, with its corners, in whole tiles.
std::size_t pixels_of_sphere();

/// The picture "scene.png" before gnuplot has drawn it: its pixels and its script, which reads them. At least
/// one way is shown.
std::vector<File> picture_files(const scene::Scene& scene, const scene::Plan& plan,
                                const ReferenceWay& reference, const std::vector<ShownWay>& ways);

}  // namespace shadefit::shade
