#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "reports/io/table.hpp"

/// Figures of the report: numbers, and how to draw them. A script for gnuplot is written from a description
/// of panels and curves. All figures share one style: a white ground, a light grid, one legend below, colours
/// that colour-blind readers can tell apart.
namespace shadefit {

/// The look of a line; its number is the line style in the script.
enum class Look {
  target = 1,  ///< a broad grey line, so that curves on top of it stay visible
  first,
  second,
  third,
  fourth,
  thin_target,        ///< the target of another figure, if it is one of the compared curves
  first_target = 10,  ///< broad and pale, under the curve of the same place in `curve_looks`
  second_target,
  third_target,
  fourth_target,
};

/// The looks of the curves that a figure compares, in their order.
inline constexpr std::array curve_looks{Look::first, Look::second, Look::third, Look::fourth};
inline constexpr std::array target_looks{Look::first_target, Look::second_target, Look::third_target,
                                         Look::fourth_target};

/// One column of the data over the panel's abscissa. Labels are gnuplot's enhanced text: x^2, x_{min}.
struct Curve {
  std::string column;
  std::string label;  ///< curves with the same label share one entry in the legend
  Look look;
  bool in_percent = false;
  bool has_points = false;  ///< for curves that are known at few places
  bool is_joined = true;    ///< by a line; else only points
};

/// A horizontal line for comparison, with a label at its right end.
struct Level {
  std::string value;
  std::string label;
};

struct Panel {
  std::string title = "";
  std::string x_label = "", y_label = "";
  std::string settings = "";  ///< gnuplot's commands for this panel, each with its line end
  std::string top_tics = "";  ///< a second axis on top: gnuplot's list of tics, "'a' 0, 'b' 1"; empty: none
  std::string abscissa;       ///< a column
  std::string where = "";     ///< the condition on a row, in gnuplot's words; empty: all rows
  std::vector<Curve> curves = {};
  std::vector<Level> levels = {};
};

struct Plot {
  std::string name;   ///< NAME.csv is read, NAME.svg written
  std::string about;  ///< one line on top of the script
  int columns;        ///< panels stand row by row
  int panel_height;   ///< in pixels; the width of the whole is always the same
  std::vector<Panel> panels;
};

/// The files in `plots/` with one name: data, script and, once drawn, the picture.
struct Figure {
  std::string name;         ///< "lobe": lobe.csv, lobe.gnuplot, lobe.svg
  std::string_view family;  ///< the family in whose section the report shows it
  std::string caption;      ///< one sentence
  Table data;
  std::string script;  ///< of gnuplot; reads NAME.csv beside it
};

/// The script: run in the directory of its data, it writes NAME.svg. Long titles and labels of the legend
/// have several lines.
std::string write_script(const Plot& plot);

/// "[low:high]" around all numbers of these columns, ends rounded outward to a twentieth or so of the span.
std::string range_around(const Table& table, const std::vector<Curve>& curves);

}  // namespace shadefit
