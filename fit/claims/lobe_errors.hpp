#pragma once

#include <optional>
#include <string>
#include <vector>

#include "approx/lobe.hpp"
#include "fit/errors/effect.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/quadrature/metric.hpp"

/// The error of the Spherical Gaussian exp((k+x)(c-1)) against c^k, its difference from another offset, and
/// the range of the best offset over all exponents.
namespace shadefit {

/// The largest |exp((k+x)(c-1)) - c^k| over c in [0, 1], k > 0.
Extremum largest_lobe_error(double exponent, double offset);

/// The same in 8-bit sRGB codes, as a real number.
double largest_lobe_codes(double exponent, double offset);

/// The largest |exp((k+x1)(c-1)) - exp((k+x2)(c-1))| over c in [0, 1], found by search; and in 8-bit sRGB
/// codes.
Extremum largest_offset_difference(double exponent, double offset, double other);
double largest_offset_codes(double exponent, double offset, double other);

/// The least-squares offset under a measure, over the whole domain; empty if the fit does not converge.
std::optional<double> best_offset(double exponent, Measure measure = Measure::cosine);

/// The minimax offset in [0, 2], and its error. As x grows, the Gaussian falls everywhere: its largest excess
/// over c^k shrinks and its largest deficit grows. At the optimum they are equal.
struct SmallestLobeError {
  double offset, error;
};
SmallestLobeError smallest_lobe_error(double exponent);

/// The place in (0, 1) where the plain Gaussian is as far from c^k as the one with this offset; nearer to the
/// peak the plain one is closer. Empty if the offset is not above 0.
std::optional<Cosine<double>> peak_crossing(double exponent, double offset);

/// |exp((k+x)(c-1)) - c^k| at a place.
double lobe_error_at(const Cosine<double>& c, double exponent, double offset);

/// Adds the change from c^k to the Gaussian, at a place, to an effect.
void show_gaussian(Effect& effect, const Cosine<double>& c, double exponent, double offset);

/// The effect of using the Gaussian for c^k.
Effect effect_of_gaussian(double exponent, double offset);

/// The effect of using one offset for another.
Effect effect_of_offset(double exponent, double from, double to);

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
