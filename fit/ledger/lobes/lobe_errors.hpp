#pragma once

#include <optional>

#include "fit/errors/effect.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/quadrature/metric.hpp"

/// How far the spherical Gaussian exp((k+x)(c-1)) is from c^k, and from itself at another offset.
namespace shadefit {

/// The largest |exp((k+x)(c-1)) - c^k| over c in [0, 1], k > 0.
Extremum largest_lobe_error(double exponent, double offset);

/// The same in 8-bit sRGB codes, as a real number.
double largest_lobe_codes(double exponent, double offset);

/// The largest |exp((k+x1)(c-1)) - exp((k+x2)(c-1))| over c in [0, 1], found by search; and in 8-bit sRGB
/// codes.
Extremum largest_offset_difference(double exponent, double offset, double other);
double largest_offset_codes(double exponent, double offset, double other);

/// The least-squares offset under a measure, over the whole domain; empty where the fit does not converge.
std::optional<double> best_offset(double exponent, Measure measure = Measure::cosine);

/// The offset in [0, 2] whose largest error is smallest, and that error: what no x undercuts. As x grows the
/// Gaussian falls everywhere, so what it exceeds c^k by shrinks and what it lacks grows: they are equal
/// there.
struct SmallestLobeError {
  double offset, error;
};
SmallestLobeError smallest_lobe_error(double exponent);

/// The place in (0, 1) where the plain Gaussian is as far from c^k as the one with this offset; nearer to the
/// peak the plain one is the closer. Empty for an offset that is not above 0: there is none.
std::optional<Cosine<double>> peak_crossing(double exponent, double offset);

/// |exp((k+x)(c-1)) - c^k| at a place.
double lobe_error_at(const Cosine<double>& c, double exponent, double offset);

/// Shows an effect what using the Gaussian for c^k does at a place.
void show_gaussian(Effect& effect, const Cosine<double>& c, double exponent, double offset);

/// What using the Gaussian for c^k does to a picture.
Effect effect_of_gaussian(double exponent, double offset);

/// What using one offset for another does to it.
Effect effect_of_offset(double exponent, double from, double to);

}  // namespace shadefit
