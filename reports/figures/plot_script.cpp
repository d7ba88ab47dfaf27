#include "reports/figures/plot_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/writers.hpp"

namespace shadefit {
namespace {

/// Pixels: the width that GitHub shows, and the space for tics, labels, titles and rows of the legend.
constexpr int picture_width = 900;
constexpr int left_edge = 88, right_edge = 22, top_edge = 18, bottom_edge = 70;
constexpr int title_height = 22, top_tics_height = 20, legend_height = 22;
constexpr int between_columns = 84, between_rows = 50;

/// Okabe and Ito's palette (jfly.uni-koeln.de/color), on grey for the target. Dashes help where curves meet.
constexpr std::string_view styles =
    "set style line 1 lc rgb '#B8B8B8' lw 5.5\n"
    "set style line 2 lc rgb '#D55E00' lw 2 pt 7 ps 0.5\n"
    "set style line 3 lc rgb '#0072B2' lw 2 pt 5 ps 0.45\n"
    "set style line 4 lc rgb '#009E73' lw 2 pt 9 ps 0.6 dt (9,4)\n"
    "set style line 5 lc rgb '#000000' lw 2 pt 13 ps 0.6 dt (3,3)\n"
    "set style line 6 lc rgb '#808080' lw 3\n"
    "set style line 8 lc rgb '#707070' lw 1.2 dt (6,4)\n"
    "set style line 9 lc rgb '#DDDDDD' lw 1\n"
    "set style line 10 lc rgb '#F2BF9E' lw 5.5\n"
    "set style line 11 lc rgb '#A5CCE4' lw 5.5\n"
    "set style line 12 lc rgb '#A0DBC9' lw 5.5\n"
    "set style line 13 lc rgb '#B3B3B3' lw 5.5\n";

/// Between the parts of a command, each on its own line.
constexpr std::string_view between_lines = ", \\\n  ";

/// Letters are about 7.5 pixels wide. An entry of the legend has 60 more for its sample.
constexpr double letter_width = 7.5;
constexpr int sample_width = 60;
/// gnuplot reserves more for a letter of the legend than it draws (measured: entries of 18 and 30 letters
/// stand 223 and 333 pixels apart), in 98 % of the picture.
constexpr double entry_letter_width = 9.2, legend_width = 0.98 * picture_width;
constexpr auto widest_entry = static_cast<std::size_t>((legend_width - sample_width) / entry_letter_width);

/// A label in lines of at most so many letters. A longer word is broken, but no character and no escape.
std::vector<std::string> lines_of_label(const std::string& label, std::size_t most) {
  std::vector<std::string> lines;
  if (label.size() <= most) return {label};
  for (std::string& line : folded(label, most)) {
    while (line.size() > most) {
      std::size_t end = most;
      while (end > 1 && ((line[end] & 0xC0) == 0x80 || line[end - 1] == '\\')) --end;
      lines.push_back(line.substr(0, end));
      line.erase(0, end);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> lines_of_title(const Plot& plot, const Panel& panel) {
  const int width =
      (picture_width - left_edge - right_edge - (plot.columns - 1) * between_columns) / plot.columns;
  return lines_of_label(panel.title, static_cast<std::size_t>(width / letter_width));
}

/// The lines beyond the first that a title of these rows of panels needs.
int more_title_lines(const Plot& plot, bool is_first_row) {
  std::size_t most = 1;
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const bool is_first = i < static_cast<std::size_t>(plot.columns);
    if (is_first == is_first_row) most = std::max(most, lines_of_title(plot, plot.panels[i]).size());
  }
  return static_cast<int>(most) - 1;
}

/// Each label once, in the order of its first curve.
std::vector<Curve> legend_of(const Plot& plot) {
  std::vector<Curve> legend;
  for (const Panel& panel : plot.panels) {
    for (const Curve& curve : panel.curves) {
      const bool is_new = std::ranges::find(legend, curve.label, &Curve::label) == legend.end();
      if (is_new) legend.push_back(curve);
    }
  }
  return legend;
}

bool has_long_entry(const std::vector<Curve>& legend) {
  return std::ranges::any_of(legend, [](const Curve& curve) { return curve.label.size() > widest_entry; });
}

/// gnuplot gives every entry the width of the longest. A legend with a longer one has a column of lines.
int rows_of_legend(const std::vector<Curve>& legend) {
  std::size_t longest = 0, lines = 0;
  for (const Curve& curve : legend) {
    longest = std::max(longest, curve.label.size());
    lines += lines_of_label(curve.label, widest_entry).size();
  }
  if (has_long_entry(legend)) return static_cast<int>(lines);
  const auto in_a_row = static_cast<std::size_t>(
      legend_width / (entry_letter_width * static_cast<double>(longest) + sample_width));
  return static_cast<int>((legend.size() + in_a_row - 1) / in_a_row);
}

/// The positions of the panels, in pixels.
struct Layout {
  int rows;
  int between;  ///< two rows
  int above;    ///< the first row
  int under;    ///< the last row
  int height;
};

Layout layout_of(const Plot& plot) {
  const auto has = [&](const std::string Panel::*text) {
    return std::ranges::any_of(plot.panels, [&](const Panel& panel) { return !(panel.*text).empty(); });
  };
  const int rows = (static_cast<int>(plot.panels.size()) + plot.columns - 1) / plot.columns;
  const int above = top_edge + (has(&Panel::title) ? title_height * (1 + more_title_lines(plot, true)) : 0) +
                    (has(&Panel::top_tics) ? top_tics_height : 0);
  const int between = between_rows + title_height * more_title_lines(plot, false);
  const int under = bottom_edge + legend_height * rows_of_legend(legend_of(plot));
  return {rows, between, above, under, above + rows * plot.panel_height + (rows - 1) * between + under};
}

std::string prelude(const Plot& plot) {
  const Layout layout = layout_of(plot);
  const auto across = [](int pixels) { return static_cast<double>(pixels) / picture_width; };
  const auto up = [&](int pixels) { return static_cast<double>(pixels) / layout.height; };
  return fmt::format(
             "# Draws {1}.svg from {1}.csv: gnuplot {1}.gnuplot\n"
             "# {0}\n"
             "# To restyle it, copy it and change the output: the next run replaces this file.\n"
             "set encoding utf8\n"
             "set terminal svg size {2},{3} font 'sans-serif,13' background '#FFFFFF'\n"
             "set output '{1}.svg'\n"
             "set datafile separator comma\n"
             "set datafile columnheaders\n"
             "set minussign\n",
             for_comment(plot.about), plot.name, picture_width, layout.height) +
         std::string(styles) +
         fmt::format(
             "set border lc rgb '#404040'\n"
             "set key off\n"
             "set multiplot layout {},{} margins screen {:.5f},{:.5f},{:.5f},{:.5f} spacing screen "
             "{:.5f},{:.5f}\n",
             layout.rows, plot.columns, across(left_edge), 1 - across(right_edge), up(layout.under),
             1 - up(layout.above), across(between_columns), up(layout.between));
}

/// gnuplot's name for how a curve is drawn.
const char* style_of(const Curve& curve) {
  if (!curve.is_joined) return "points";
  return curve.has_points ? "linespoints" : "lines";
}

std::string command_of(const Plot& plot, const Panel& panel, const Curve& curve) {
  const std::string x = panel.where.empty() ? fmt::format("(column({}))", gnuplot_quoted(panel.abscissa))
                                            : fmt::format("({} ? column({}) : NaN)", panel.where,
                                                          gnuplot_quoted(panel.abscissa));
  return fmt::format("'{}.csv' using {}:({}column({})) with {} ls {} notitle", plot.name, x,
                     curve.in_percent ? "100*" : "", gnuplot_quoted(curve.column), style_of(curve),
                     static_cast<int>(curve.look));
}

/// Each panel starts from the same settings, independent of the previous one. The label of its y axis has a
/// fixed distance; gnuplot would base it on the width of the tics and place it outside the picture.
std::string panel_text(const Plot& plot, const Panel& panel) {
  std::string out = fmt::format(
      "\nunset arrow; unset label; unset logscale; unset x2tics; set autoscale; set format\n"
      "set tics nomirror out scale 0.5; set xtics auto; set ytics auto; set grid xtics ytics ls 9\n"
      "set border {}\n"
      "set title {} offset 0,-0.4\n"
      "set xlabel {}\n"
      "set label {} at graph 0, graph 0.5 center rotate offset char -8.6,0\n",
      panel.top_tics.empty() ? 3 : 7, joined(lines_of_title(plot, panel), ".\"\\n\".", gnuplot_quoted),
      gnuplot_quoted(panel.x_label), gnuplot_quoted(panel.y_label));
  if (!panel.top_tics.empty())
    out += fmt::format("set x2tics ({}) out scale 0.5 textcolor '#606060'\n", panel.top_tics);
  out += panel.settings;
  for (const Level& level : panel.levels) {
    out += fmt::format(
        "set arrow from graph 0, first {0} to graph 1, first {0} nohead ls 8 back\n"
        "set label {1} at graph 0.99, first {0} right offset 0,0.55 textcolor '#505050'\n",
        level.value, gnuplot_quoted(level.label));
  }
  const auto command = [&](const Curve& curve) { return command_of(plot, panel, curve); };
  return out + fmt::format("plot {}\n", joined(panel.curves, between_lines, command));
}

/// One legend for all panels: the key of an additional empty panel, as wide as the picture.
std::string legend_text(const Plot& plot) {
  const auto legend = legend_of(plot);
  const bool is_column = has_long_entry(legend);
  const std::string entries = joined(legend, "", [&](const Curve& curve) {
    const auto lines = lines_of_label(curve.label, widest_entry);
    std::string text = fmt::format("{}keyentry with {} ls {} title {}", between_lines, style_of(curve),
                                   static_cast<int>(curve.look), gnuplot_quoted(lines.front()));
    for (std::size_t i = 1; i < lines.size(); ++i)
      text += fmt::format("{}keyentry with lines lc rgb '#FFFFFF' title {}", between_lines,
                          gnuplot_quoted(lines[i]));
    return text;
  });
  return fmt::format(
      "\nunset arrow; unset label; unset logscale; unset x2tics; unset xtics; unset ytics; unset border\n"
      "unset title; unset xlabel\n"
      "set margins at screen 0.01, screen 0.99, screen 0, screen {:.5f}\n"
      "set key on inside center center {} Left reverse samplen 2.5 width 1\n"
      "plot [0:1][0:1] 2 notitle{}\n",
      static_cast<double>(legend_height * rows_of_legend(legend)) / layout_of(plot).height,
      is_column ? "vertical maxcols 1" : "horizontal", entries);
}

}  // namespace

std::string write_script(const Plot& plot) {
  std::string out = prelude(plot);
  for (const Panel& panel : plot.panels) out += panel_text(plot, panel);
  return out + legend_text(plot) + "\nunset multiplot\n";
}

std::string range_around(const Table& table, const std::vector<Curve>& curves) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& curve : curves) {
    const auto column = std::ranges::find(table.columns, curve.column);
    const auto i = static_cast<std::size_t>(column - table.columns.begin());
    for (const auto& row : table.rows) {
      const auto* number = std::get_if<Number>(&row.at(i));
      if (number == nullptr) continue;
      const double value = number->value * (curve.in_percent ? 100 : 1);
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  const double step = std::pow(10, std::floor(std::log10(high - low))) / 2;
  return fmt::format("[{:.6g}:{:.6g}]", std::floor(low / step) * step, std::ceil(high / step) * step);
}

}  // namespace shadefit
