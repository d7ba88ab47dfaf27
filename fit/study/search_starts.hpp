#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "fit/study/study.hpp"

/// Where the search for the basins of a study starts.
namespace shadefit {

/// Where descents start.
struct SearchStarts {
  std::size_t count;  ///< of a low-discrepancy sequence, from its element `first` on
  int octaves;        ///< its values are of either sign, of sizes from 2^-octaves to 2^octaves
  std::vector<std::vector<double>> given;
  /// The units of all parameters, powers of two, if some are far from 1. Then as many starts again have these
  /// units.
  std::vector<double> units = {};
  /// If the form has positions, as d of (x - d)^2: the range of each parameter that is one, empty for the
  /// others. Then twice as many starts again have positions evenly in their ranges, and the others around
  /// `sizes`.
  std::vector<std::optional<std::array<double, 2>>> ranges = {};
  std::vector<double> sizes = {};
  std::size_t first = 1;
  std::vector<std::array<double, 2>> bounds = {};  ///< of all parameters, if any has: starts lie inside

  std::size_t sets() const { return std::size_t{1} + !units.empty() + 2 * !ranges.empty(); }
};

/// Constants of shading are between 1/64 and 64 in size, because their variables are of the size of 1.
inline constexpr int octaves_of_shading = 6;

/// The power of two next to a size that is far from 1, else 1.
double unit_of(double size);

/// A value that is outside of bounds goes as far to the other side of the bound, and round again.
double folded(double value, const std::array<double, 2>& bounds);

/// A start of all parameters: those that are not given are 1, and those outside their bounds are moved to
/// them.
std::vector<double> start_of(const ReadStudy& study, const std::vector<Held>& starts);

/// The starts for so many parameters that do not enter linearly. Constants of shading are between 1/64 and 64
/// in size, because their variables are of the size of 1. Rows have units: if their numbers are larger or
/// smaller, the range is wider and there are more starts.
SearchStarts starts_of(const ReadStudy& study, std::size_t nonlinear);

/// All of them, for so many parameters that do not enter linearly: those that are given, a sequence in the
/// units of the study, and what form and target say: a descent finds a frequency only from within about half
/// a period over the range, and a peak only from beside it. `target` has its values at nodes.
SearchStarts search_starts(const ReadStudy& study, std::size_t nonlinear, const std::vector<double>& target,
                           const std::vector<Held>& given);

}  // namespace shadefit
