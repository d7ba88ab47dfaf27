#include "bench/tradeoff/labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace shadefit::bench
