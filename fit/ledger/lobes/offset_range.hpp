#pragma once

#include <optional>
#include <string>
#include <vector>

#include "approx/lobe.hpp"
#include "fit/quadrature/metric.hpp"

/// The range of the best offset of a Spherical Gaussian over all exponents.
namespace shadefit {

/// The best offset over all exponents, under one measure.
struct OffsetRange {
  Measure measure;
  double lowest, lowest_at;    ///< of the sweep
  double highest, highest_at;  ///< of the sweep and between its exponents
  double blunt_slope;          ///< x = blunt_slope k for k -> 0
  ApproachLaw<double> law;     ///< and as k grows
  bool laws_hold;              ///< at both ends of the sweep the fits agree with the laws

  /// For every k. The best offset of blunt lobes tends to 0. That is the greatest lower bound, because no x
  /// of the sweep is below it.
  bool is_within(double low, double high) const {
    return std::min(lowest, 0.0) >= low && std::max(highest, law.limit) <= high;
  }
};

/// For the least-squares fits at the rising exponents, and between them. Empty if a fit does not converge.
std::optional<OffsetRange> offset_range(Measure measure, const std::vector<double>& exponents);

std::string sentence(const OffsetRange& range);

}  // namespace shadefit
