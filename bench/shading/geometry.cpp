#include "bench/shading/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/forms/catalogue.hpp"

namespace shadefit::shade {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector normalised(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vector to_eye(const Vector& point) {
  return normalised({-point[0], -point[1], eye_distance - point[2]});
}

/// A tile is a square of pixels of a sphere that is `sphere_pixels` wide: large on a screen, so that
/// neighbours are similar.
constexpr int tile_side = 8, sphere_pixels = 256;
static_assert(tile_side * tile_side == tile_pixels);

using TileNormals = std::array<Vector, tile_pixels>;

/// The normals of a tile around a place of the sphere's disc; nothing if a pixel is not visible.
std::optional<TileNormals> normals_around(double x, double y) {
  TileNormals normals;
  for (int row = 0; row < tile_side; ++row) {
    for (int column = 0; column < tile_side; ++column) {
      constexpr double pixel = 2.0 / sphere_pixels, middle = (tile_side - 1) / 2.0;
      const double u = x + pixel * (column - middle), v = y + pixel * (row - middle);
      const double square = 1 - u * u - v * v;
      if (square <= 0) return std::nullopt;
      const Vector normal{u, v, std::sqrt(square)};
      if (dot(normal, to_eye(normal)) <= 0) return std::nullopt;
      normals[static_cast<std::size_t>(row * tile_side + column)] = normal;
    }
  }
  return normals;
}

bool is_lit(const TileNormals& normals, const Vector& light) {
  return std::all_of(normals.begin(), normals.end(), [&](const Vector& n) { return dot(n, light) > 0; });
}

}  // namespace

Sample sample_of(const Vector& normal, const Vector& light) {
  const Vector view = to_eye(normal);
  const Vector half = normalised({light[0] + view[0], light[1] + view[1], light[2] + view[2]});
  const auto cosine = [](double value) { return std::clamp(value, 0.0, 1.0); };
  return {cosine(dot(normal, half)), cosine(dot(light, half)), cosine(dot(normal, light))};
}

Cosines::Cosines(std::size_t tiles, std::size_t lights) : tiles_(tiles), lights_(lights) {
  auto& [narrow, wide] = cosines_;
  for (auto& all : narrow) all.resize(tiles * lights * tile_pixels);
  for (auto& all : wide) all.resize(tiles * lights * tile_pixels);
}

void Cosines::set(std::size_t tile, std::size_t light, std::size_t pixel, const Sample& sample) {
  const std::size_t at = (tile * lights_ + light) * tile_pixels + pixel;
  const std::array values{sample.n_dot_h, sample.l_dot_h, sample.n_dot_l};
  auto& [narrow, wide] = cosines_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    narrow[i][at] = static_cast<float>(values[i]);
    wide[i][at] = static_cast<double>(narrow[i][at]);
  }
}

std::vector<Cosines> sphere_blocks(std::size_t blocks, std::size_t tiles, std::size_t lights) {
  std::vector<Cosines> all(blocks, Cosines(tiles, lights));
  std::size_t next_place = 0, next_light = 0;
  for (std::size_t i = 0; i < blocks * tiles; ++i) {
    std::optional<TileNormals> normals;
    while (!normals) {
      const Vector place = forms::spread_direction(next_place++);
      normals = normals_around(place[0], place[1]);
    }
    for (std::size_t light = 0; light < lights; ++light) {
      Vector direction = forms::spread_direction(next_light++);
      while (!is_lit(*normals, direction)) direction = forms::spread_direction(next_light++);
      for (std::size_t p = 0; p < tile_pixels; ++p)
        all[i / tiles].set(i % tiles, light, p, sample_of((*normals)[p], direction));
    }
  }
  return all;
}

}  // namespace shadefit::shade
