#pragma once

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

/// A logarithmic axis.
struct LogarithmicAxis {
  double low, high;
  /// The place of a value, from 0 at `low` to 1 at `high`.
  double share(double value) const;
};

/// An axis for these numbers, with a free share at both ends.
LogarithmicAxis axis_around(const std::vector<double>& values, double free_below, double free_above);

/// gnuplot's settings for two such axes.
std::string axis_settings(const LogarithmicAxis& x, const LogarithmicAxis& y);

/// gnuplot's commands for a name: the text, with more options, and a line to its point if it is far away.
/// `size` is that of the area between the axes.
std::string label_commands(const Label& label, const std::string& name, const Pixel& point, const Pixel& size,
                           const std::string& options = "");

/// Positions for the names of the first `names.size()` points: close to the point if there is room, else
/// farther away. Names avoid all points, including those without a name, avoid each other, and stay within
/// `size`.
std::vector<Label> place_labels(const std::vector<Pixel>& points, const std::vector<std::string>& names,
                                const Pixel& size);

}  // namespace shadefit::bench
