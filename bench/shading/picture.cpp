#include "bench/shading/picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "approx/encoding.hpp"
#include "bench/timing/statistics.hpp"
#include "fit/support/decimal.hpp"
#include "reports/io/gnuplot_text.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit::shade {
namespace {

/// Pixels: a sphere, its place in a row, the space left of the rows and below them.
constexpr int diameter = 116, cell = 132, left_of_rows = 136, below_rows = 52, above_rows = 10;
/// The least width, so that a picture with few spheres has room for its words.
constexpr int least_cells = 3;

/// The background: grey, neither dark nor bright.
constexpr double ground_code = 118;

using Colour = std::array<double, 3>;

/// From the upper left, before the spheres.
constexpr std::array<double, 3> key_light{-0.5, 0.6, 0.6244997998398398};

/// The position of a pixel on a sphere, from -1 to 1; rows run downwards.
double coordinate(int pixel) {
  return (2 * pixel + 1) / static_cast<double>(diameter) - 1;
}

/// The share of a pixel that its sphere covers: 0 or 1 except at the edge.
double coverage(double x, double y) {
  return std::clamp((1 - std::hypot(x, y)) * diameter / 2 + 0.5, 0.0, 1.0);
}

/// The cosines of all pixels of a sphere, row by row, tile after tile.
Cosines cosines_of_sphere() {
  constexpr std::size_t pixels = diameter * diameter;
  Cosines cosines(pixels_of_sphere() / tile_pixels, 1);
  for (std::size_t i = 0; i < pixels; ++i) {
    double x = coordinate(static_cast<int>(i % diameter)), y = -coordinate(static_cast<int>(i / diameter));
    // A place beyond the edge gets the colour of the edge, because some of it is blended with the background.
    constexpr double edge = 0.999;
    const double length = std::hypot(x, y), inwards = length > edge ? edge / length : 1;
    x *= inwards;
    y *= inwards;
    cosines.set(i / tile_pixels, 0, i % tile_pixels,
                sample_of({x, y, std::sqrt(1 - x * x - y * y)}, key_light));
  }
  return cosines;
}

/// A sphere by the reference and by each way, in sRGB codes, pixel by pixel.
struct ShownSphere {
  std::vector<Colour> reference;
  std::vector<std::vector<Colour>> ways;
};

template <class Real>
std::vector<Colour> colours_of(const Results<Real>& results, bool is_coloured) {
  std::vector<Colour> colours(static_cast<std::size_t>(diameter) * diameter);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      colours[i][c] = srgb_code(static_cast<double>(results.channel(is_coloured ? c : 0)[i]));
  }
  return colours;
}

ShownSphere shown_sphere(const Sphere& sphere, const Cosines& cosines, bool is_textured,
                         const ReferenceWay& reference, const std::vector<ShownWay>& ways) {
  const std::size_t tiles = cosines.tiles();
  const std::vector<float> alpha(tiles * tile_pixels, static_cast<float>(alpha_of_power(sphere.power)));
  const std::vector<double> wide_alpha(alpha.begin(), alpha.end());
  Results<double> truth(tiles);
  Block<double> wide = cosines.block<double>();
  wide.alpha = is_textured ? wide_alpha.data() : nullptr;
  wide.out = truth.out();
  reference.shade(wide, sphere.material);
  ShownSphere shown{.reference = colours_of(truth, true), .ways = {}};
  for (const ShownWay& some : ways) {
    Results<float> result(tiles);
    Block<float> narrow = cosines.block<float>();
    narrow.alpha = is_textured ? alpha.data() : nullptr;
    narrow.out = result.out();
    some.way.shade(narrow, sphere.material);
    shown.ways.push_back(colours_of(result, some.way.is_coloured));
  }
  return shown;
}

/// Puts a sphere on a picture, with its upper left corner there, blended with the ground around it. A picture
/// has three bytes a pixel, rows downwards.
void put(std::string& picture, int width, int left, int top, const std::vector<Colour>& colours) {
  for (int row = 0; row < diameter; ++row) {
    for (int column = 0; column < diameter; ++column) {
      const double share = coverage(coordinate(column), coordinate(row));
      const Colour& colour = colours[static_cast<std::size_t>(row * diameter + column)];
      const auto at = static_cast<std::size_t>(3 * ((top + row) * width + left + column));
      for (std::size_t c = 0; c < 3; ++c) {
        const double code = share * std::min(colour[c], 255.0) + (1 - share) * ground_code;
        picture[at + c] = static_cast<char>(static_cast<unsigned char>(std::lround(code)));
      }
    }
  }
}

std::vector<Colour> difference(const ShownSphere& sphere, double factor) {
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < sphere.reference.size(); ++i) {
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c)
      colour[c] = factor * std::abs(sphere.ways.back()[i][c] - sphere.reference[i][c]);
    colours.push_back(colour);
  }
  return colours;
}

/// The largest factor, a power of two up to 4096, with which nearly all differences stay in the range of the
/// display: only a few pixels at an edge exceed it.
int amplification(const std::vector<ShownSphere>& spheres) {
  std::vector<double> all;
  for (const ShownSphere& sphere : spheres) {
    for (const Colour& colour : difference(sphere, 1)) {
      const double largest = *std::max_element(colour.begin(), colour.end());
      if (largest > 0) all.push_back(largest);
    }
  }
  if (all.empty()) return 1;
  std::sort(all.begin(), all.end());
  constexpr double next_to_all = 0.99;
  const double shown = bench::quantile(all, next_to_all);
  int factor = 1;
  constexpr int most = 4096;
  while (factor < most && 2 * factor * shown <= 255) factor *= 2;
  return factor;
}

/// The part of a name that fits below a sphere.
std::string shortened(const std::string& name) {
  constexpr std::size_t most = 15;
  std::string result;
  const std::vector<std::string> pieces = printable_pieces(name);
  for (std::size_t i = 0; i < pieces.size() && i < most; ++i) result += pieces[i];
  return pieces.size() > most ? result + ".." : result;
}

/// Usual powers are printed without an exponent of ten.
std::string power_text(double power) {
  constexpr double few_digits = 1000, usual = 1e6;
  return power < few_digits || power > usual ? decimal(power, 3) : fmt::format("{:.0f}", power);
}

std::string label(const std::string& text, int x, int y, const char* place) {
  return fmt::format("set label {} at {},{} {} noenhanced textcolor '#F4F4F4' front\n",
                     gnuplot_quoted(printable(text)), x, y, place);
}

std::string script_of(const scene::Scene& scene, const std::vector<Sphere>& spheres,
                      const std::vector<std::string>& rows, int width, int height) {
  // From the middle of the first pixel to the middle of the last: then gnuplot draws each pixel unchanged. It
  // blends pixels at the border with the same grey.
  std::string script = fmt::format(
      "# A scene's materials: {5}\n"
      "if (!exists('output')) output = 'scene.png'\n"
      "set encoding utf8\n"
      "set terminal pngcairo size {0},{1} font 'sans-serif,10' background '#{2:02X}{2:02X}{2:02X}'\n"
      "set output output\n"
      "unset border\nunset tics\nunset key\n"
      "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen 1\n"
      "set xrange [0.5:{3}]\nset yrange [0.5:{4}]\n",
      width, height, static_cast<int>(ground_code), width - 0.5, height - 0.5, fmt::join(rows, ", "));
  for (std::size_t row = 0; row < rows.size(); ++row)
    script += label(rows[row], 12, height - above_rows - static_cast<int>(row) * cell - cell / 2, "left");
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const int middle = left_of_rows + static_cast<int>(i) * cell + cell / 2;
    script += label(shortened(scene.materials[spheres[i].material].name), middle, below_rows - 14, "center");
    script += label("n = " + power_text(spheres[i].power), middle, below_rows - 32, "center");
  }
  return script + fmt::format(
                      "plot 'scene.rgb' binary array=({0},{1}) flipy origin=(0.5,0.5) format='%uchar' using "
                      "1:2:3 with rgbimage\n",
                      width, height);
}

/// The power below which this share of the texels lies.
double quantile_of(const std::vector<scene::PowerShare>& powers, double share) {
  double below = 0;
  for (const scene::PowerShare& some : powers) {
    below += some.share;
    if (share <= below) return some.power;
  }
  return powers.back().power;
}

}  // namespace

std::vector<Sphere> spheres_of(const scene::Scene& scene, const scene::Plan& plan) {
  std::vector<std::size_t> order;
  const auto add = [&](const auto& belongs) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      if (belongs(i)) order.push_back(i);
  };
  add([&](std::size_t i) { return plan.materials[i].has_lobe; });
  add([&](std::size_t i) { return !plan.materials[i].has_lobe && !is_black(scene.materials[i]); });
  // A black sphere is shown only if there is no other.
  if (order.empty()) add([](std::size_t) { return true; });
  order.resize(std::min(order.size(), most_spheres));
  // The rest of the row shows the powers of textured materials.
  const auto is_textured = [&](std::size_t i) { return scene.materials[i].is_power_textured(); };
  const auto textured = static_cast<std::size_t>(std::count_if(order.begin(), order.end(), is_textured));
  const std::size_t more = textured == 0 ? 0 : (most_spheres - order.size()) / textured;
  std::vector<Sphere> spheres;
  for (const std::size_t i : order) {
    const auto& powers = scene.materials[i].powers;
    const std::size_t count = is_textured(i) ? 1 + more : 1;
    for (std::size_t k = 0; k < count; ++k)
      spheres.push_back(
          {i, quantile_of(powers, (static_cast<double>(k) + 0.5) / static_cast<double>(count))});
  }
  return spheres;
}

std::size_t pixels_of_sphere() {
  constexpr std::size_t pixels = diameter * diameter;
  return (pixels + tile_pixels - 1) / tile_pixels * tile_pixels;
}

std::vector<File> picture_files(const scene::Scene& scene, const scene::Plan& plan,
                                const ReferenceWay& reference, const std::vector<ShownWay>& ways) {
  const std::vector<Sphere> spheres = spheres_of(scene, plan);
  const Cosines cosines = cosines_of_sphere();
  std::vector<ShownSphere> shown;
  for (const Sphere& sphere : spheres) {
    const bool is_textured = scene.materials[sphere.material].is_power_textured();
    shown.push_back(shown_sphere(sphere, cosines, is_textured, reference, ways));
  }
  const int factor = amplification(shown);
  std::vector<std::string> rows{"reference"};
  for (const ShownWay& way : ways) rows.push_back(way.name);
  rows.push_back(fmt::format("difference x {}", factor));
  const int width = left_of_rows + cell * std::max(static_cast<int>(spheres.size()), least_cells);
  const int height = above_rows + static_cast<int>(rows.size()) * cell + below_rows;
  std::string picture(static_cast<std::size_t>(3 * width * height), static_cast<char>(ground_code));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const int left = left_of_rows + static_cast<int>(i) * cell + (cell - diameter) / 2;
    int top = above_rows + (cell - diameter) / 2;
    put(picture, width, left, top, shown[i].reference);
    for (const std::vector<Colour>& way : shown[i].ways) put(picture, width, left, top += cell, way);
    put(picture, width, left, top + cell, difference(shown[i], factor));
  }
  return {{"plots/scene.rgb", picture},
          {"plots/scene.gnuplot", script_of(scene, spheres, rows, width, height)}};
}

}  // namespace shadefit::shade
