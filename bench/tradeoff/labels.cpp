#include "bench/tradeoff/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/io/gnuplot_text.hpp"

namespace shadefit::bench {
namespace {

struct Box {
  double left, top, right, bottom;
};

/// The area that two boxes share.
double overlap(const Box& a, const Box& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

Box around(const Pixel& point) {
  constexpr double radius = 5;
  return {point.x - radius, point.y - radius, point.x + radius, point.y + radius};
}

Box box_of(const Pixel& middle_left, double width) {
  return {middle_left.x, middle_left.y - line_height / 2, middle_left.x + width,
          middle_left.y + line_height / 2};
}

/// The area of a box outside of the picture.
double outside(const Box& box, const Pixel& size) {
  const Box all{0, 0, size.x, size.y};
  return (box.right - box.left) * (box.bottom - box.top) - overlap(box, all);
}

/// The possible places of a text around its point: the sides first, then larger and larger circles.
std::vector<Label> candidates(const Pixel& point, double width) {
  std::vector<Label> places;
  for (const double distance : {9.0, 24.0, 42.0, 62.0, 84.0, 108.0, 134.0, 162.0, 192.0, 224.0}) {
    constexpr int directions = 16;
    for (int i = 0; i < directions; ++i) {
      // To the right, then in turn to both sides of that: 0, 1, -1, 2, -2 ..
      const int step = i % 2 == 1 ? (i + 1) / 2 : -i / 2;
      const double angle = -step * 2 * std::numbers::pi / directions;
      const double across = std::cos(angle), up = std::sin(angle);
      const Pixel anchor{point.x + distance * across,
                         point.y + (distance + (std::abs(up) > 0.9 ? 3 : 0)) * up};
      const double left = across > 0.3 ? anchor.x : across < -0.3 ? anchor.x - width : anchor.x - width / 2;
      places.push_back({{left, anchor.y}, distance > 30});
    }
  }
  return places;
}

}  // namespace

std::vector<Label> place_labels(const std::vector<Pixel>& points, const std::vector<std::string>& names,
                                const Pixel& size) {
  std::vector<Box> taken;
  for (const Pixel& point : points) taken.push_back(around(point));
  std::vector<Label> labels;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double width = letter_width * static_cast<double>(names[i].size());
    Label best{};
    double least = -1;
    for (const Label& candidate : candidates(points[i], width)) {
      const Box box = box_of(candidate.middle_left, width);
      double covered = outside(box, size);
      for (const Box& other : taken) covered += overlap(box, other);
      if (least < 0 || covered < least) {
        least = covered;
        best = candidate;
      }
      if (least <= 0) break;
    }
    labels.push_back(best);
    taken.push_back(box_of(best.middle_left, width));
  }
  return labels;
}

double LogarithmicAxis::share(double value) const {
  return std::log(value / low) / std::log(high / low);
}

LogarithmicAxis axis_around(const std::vector<double>& values, double free_below, double free_above) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double decades = std::max(std::log10(*high / *low), 0.5);
  return {*low * std::pow(10, -free_below * decades), *high * std::pow(10, free_above * decades)};
}

std::string axis_settings(const LogarithmicAxis& x, const LogarithmicAxis& y) {
  return fmt::format(
      "set logscale xy\nset xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n"
      "set format y '10^{{%L}}'\nset format x '%g'\n",
      x.low, x.high, y.low, y.high);
}

std::string label_commands(const Label& label, const std::string& name, const Pixel& point, const Pixel& size,
                           const std::string& options) {
  const Pixel& at = label.middle_left;
  std::string commands = fmt::format("set label {} at graph {:.5f}, graph {:.5f} left noenhanced{} front\n",
                                     gnuplot_quoted(name), at.x / size.x, 1 - at.y / size.y, options);
  if (!label.has_leader) return commands;
  const double end = std::clamp(point.x, at.x, at.x + letter_width * static_cast<double>(name.size()));
  const double edge = at.y + (point.y > at.y ? line_height / 2 : -line_height / 2);
  return commands + fmt::format(
                        "set arrow from graph {:.5f}, graph {:.5f} to graph {:.5f}, graph {:.5f} nohead "
                        "lc rgb '#B0B0B0' lw 0.8 back\n",
                        end / size.x, 1 - edge / size.y, point.x / size.x, 1 - point.y / size.y);
}

}  // namespace shadefit::bench
