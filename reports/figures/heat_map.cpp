#include "reports/figures/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fit/better/sampled_curve.hpp"
#include "reports/io/table.hpp"

namespace shadefit {
namespace {

constexpr double map_size = 300, map_gap = 90, map_left = 90, map_top = 32, map_bottom = 34;

/// The errors by x, then by y. With measured rows these are the values that occur.
using ErrorMap = std::map<double, std::map<double, double>>;

ErrorMap error_map(const StudyComparison& comparison, const StudyContender& contender) {
  const SampledCurve curve = sample_curve(formulas_of(comparison, contender), contender.values);
  const bool is_relative = comparison.error == "max_rel_error";
  ErrorMap errors;
  for (std::size_t i = 0; i < curve.places.size(); ++i) {
    const double difference = curve.form[i] - curve.target[i];
    errors[curve.places[i][0]][curve.places[i][1]] = is_relative ? difference / curve.target[i] : difference;
  }
  return errors;
}

double largest_error_in(const ErrorMap& errors) {
  double largest = 0;
  for (const auto& [x, column] : errors)
    for (const auto& [y, error] : column)
      if (std::isfinite(error)) largest = std::max(largest, std::abs(error));
  return largest;
}

/// Cells of equal size, starting at the lower left. A grid of 49 x 49 places is thinned to every second one.
std::string cells(const ErrorMap& errors, double limit, double left) {
  constexpr std::size_t most_in_a_row = 36;
  const std::size_t step = errors.size() > most_in_a_row ? 2 : 1;
  const std::size_t columns = (errors.size() + step - 1) / step;
  const double width = map_size / static_cast<double>(columns);
  std::string svg;
  std::size_t i = 0;
  for (const auto& [x, column] : errors) {
    const std::size_t rows = (column.size() + step - 1) / step;
    const double height = map_size / static_cast<double>(rows);
    std::size_t j = 0;
    for (const auto& [y, error] : column) {
      const double share = std::abs(error) / limit;
      if (i % step == 0 && j % step == 0 && share >= 0.005)  // fainter cells are not visible
        svg += fmt::format(
            "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill-opacity=\"{:.2f}\"/>\n",
            error > 0 ? "over" : "under", left + width * static_cast<double>(i / step),
            map_top + map_size - height * static_cast<double>(j / step + 1), width, height,
            std::min(share, 1.0));
      ++j;
    }
    ++i;
  }
  return svg +
         fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                     left, map_top, map_size, map_size);
}

std::string labels(const ErrorMap& errors, const std::vector<std::string>& variables, double left,
                   const std::string& title) {
  const auto number = [](double value) { return text(Number{value, 3}, Precision::report); };
  const auto& column = errors.begin()->second;
  const double below = map_top + map_size + 18;
  return svg_text(left, map_top - 8, "start", title) +
         svg_text(left, below, "start", number(errors.begin()->first)) +
         svg_text(left + map_size / 2, below, "middle", variables[0]) +
         svg_text(left + map_size, below, "end", number(errors.rbegin()->first)) +
         svg_text(left - 6, map_top + map_size, "end", number(column.begin()->first)) +
         svg_text(left - 6, map_top + map_size / 2, "end", variables[1]) +
         svg_text(left - 6, map_top + 10, "end", number(column.rbegin()->first));
}

}  // namespace

std::string heat_map_svg(const StudyComparison& comparison,
                         const std::vector<const StudyContender*>& contenders) {
  if (comparison.variables.size() != 2 || contenders.empty()) return "";
  std::vector<ErrorMap> maps;
  double limit = 0;
  for (const StudyContender* contender : contenders) {
    maps.push_back(error_map(comparison, *contender));
    limit = std::max(limit, largest_error_in(maps.back()));
  }
  if (!(limit > 0)) return "";
  // Room for two maps, so that one alone is not larger.
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" shape-rendering=\"crispEdges\" aria-label=\"the error over {} and {}\">\n",
      map_left + 2 * map_size + map_gap + 10, map_top + map_size + map_bottom, comparison.variables[0],
      comparison.variables[1]);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const double left = map_left + static_cast<double>(i) * (map_size + map_gap);
    const std::string largest = text(Number{largest_error_in(maps[i]), 3}, Precision::report);
    svg += cells(maps[i], limit, left) +
           labels(maps[i], comparison.variables, left,
                  (i == 0 ? "as published, at most " : "better, at most ") + largest);
  }
  return svg + "</svg>\n";
}

}  // namespace shadefit
