#pragma once

#include <optional>
#include <string>
#include <vector>

#include "approx/lobe.hpp"
#include "fit/quadrature/metric.hpp"

/// Where the best offset of a spherical Gaussian lies, whatever the exponent.
namespace shadefit {

/// The best offset over all exponents, under one measure.
struct OffsetRange {
  Measure measure;
  double lowest, lowest_at;    ///< of the sweep
  double highest, highest_at;  ///< of the sweep and between its exponents
  double blunt_slope;          ///< x = blunt_slope k for k -> 0
  ApproachLaw<double> law;     ///< and as k grows
  bool laws_hold;              ///< at both ends of the sweep the fits are where the laws say

  /// For every k. 0, to which blunt lobes lead, is the greatest lower bound as no x of the sweep is below it.
  bool is_within(double low, double high) const {
    return std::min(lowest, 0.0) >= low && std::max(highest, law.limit) <= high;
  }
};

/// Of the least-squares fits at the rising exponents, and between them. Empty where a fit does not converge.
std::optional<OffsetRange> offset_range(Measure measure, const std::vector<double>& exponents);

std::string sentence(const OffsetRange& range);

}  // namespace shadefit
