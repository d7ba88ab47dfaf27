#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Places names next to the points of a picture without overlaps.
namespace shadefit::bench {

/// A position in pixels, from the upper left corner of the drawing area.
struct Pixel {
  double x, y;
};

/// A text on one line.
struct Label {
  Pixel middle_left;  ///< the start of the text
  bool has_leader;    ///< it is so far from its point that it needs a leader line
};

/// The width of a letter of the pictures' font, an upper bound of the average for most texts, and the height
/// of a line.
inline constexpr double letter_width = 7.2, line_height = 16;

/// Positions for the names of the first `names.size()` points: close to the point if there is room, else
/// farther away. Names avoid all points, including those without a name, avoid each other, and stay within
/// `size`.
std::vector<Label> place_labels(const std::vector<Pixel>& points, const std::vector<std::string>& names,
                                const Pixel& size);

}  // namespace shadefit::bench
