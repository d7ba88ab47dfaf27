#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Names beside points of a picture, so that none lies over another or over a point.
namespace shadefit::bench {

/// A place in pixels, from the upper left corner of what is drawn in.
struct Pixel {
  double x, y;
};

/// A text on one line.
struct Label {
  Pixel middle_left;  ///< where it begins
  bool has_leader;    ///< it stands so far from its point that a line has to lead there
};

/// What a letter of the pictures' font takes, on average and at most for most texts, and a line of text.
inline constexpr double letter_width = 7.2, line_height = 16;

/// A place for the name of each of the first `names.size()` points: close to it where there is room, farther
/// off where there is none. Names keep off every point, those without a name too, off each other, and within
/// `size`.
std::vector<Label> place_labels(const std::vector<Pixel>& points, const std::vector<std::string>& names,
                                const Pixel& size);

}  // namespace shadefit::bench
