#include "fit/claims/lobe_errors.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>

#include "approx/encoding.hpp"
#include "approx/lobe.hpp"
#include "approx/lobe_laws.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/where.hpp"
#include "fit/support/format.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

double blunt_slope(Measure measure) {
  return measure == Measure::cosine  ? blunt_offset_slope_cosine<double>()
         : measure == Measure::angle ? blunt_offset_slope_angle<double>()
                                     : blunt_offset_slope_cosine_weighted<double>();
}

/// The substitution for an extremum: all cosines, scaled to the lobe.
Substitution places(double exponent) {
  return {Metric{}, {.concentration = 2 * exponent, .end_power = exponent}};
}

/// The Gaussian, and c^k, as functions of the cosine in any scalar; their difference without cancellation.
auto gaussian(double exponent, double offset) {
  return [=]<class T>(const Cosine<T>& c) {
    return gaussian_lobe_near_peak(c.one_minus_cos, lift<T>(exponent), lift<T>(offset));
  };
}

auto target(double exponent) {
  return [=]<class T>(const Cosine<T>& c) {
    const T k = lift<T>(exponent);
    return T(gaussian_lobe_near_peak(c.one_minus_cos, k, integer<T>(0)) *
             exp(lobe_log_ratio(c.cos_theta, c.one_minus_cos, k)));
  };
}

auto error(double exponent, double offset) {
  return [=]<class T>(const Cosine<T>& c) {
    const T k = lift<T>(exponent);
    return lobe_error(gaussian_lobe_near_peak(c.one_minus_cos, k, integer<T>(0)),
                      T(-(lift<T>(offset) * c.one_minus_cos)),
                      T(expm1(lobe_log_ratio(c.cos_theta, c.one_minus_cos, k))));
  };
}

template <class A, class B>
double largest_codes(const A& a, const B& b, double exponent) {
  const Substitution substitution = places(exponent);
  return largest_sampled([&](double s) {
    const Cosine<double> c = substitution.at(s).cosine;
    return std::abs(srgb_code(double(a(c))) - srgb_code(double(b(c))));
  });
}

}  // namespace

std::optional<OffsetRange> offset_range(Measure measure, const std::vector<double>& exponents) {
  std::vector<double> offsets;
  for (const double exponent : exponents) {
    const auto offset = best_offset(exponent, measure);
    if (!offset) return std::nullopt;
    offsets.push_back(*offset);
  }
  const auto least = static_cast<std::size_t>(std::ranges::min_element(offsets) - offsets.begin());
  const auto best = static_cast<std::size_t>(std::ranges::max_element(offsets) - offsets.begin());
  // The place of a maximum has half the digits, the largest x has all.
  std::uintmax_t steps = 30;
  const auto peak = boost::math::tools::brent_find_minima(
      [&](double log_exponent) { return -best_offset(std::exp(log_exponent), measure).value_or(0); },
      std::log(exponents[best == 0 ? 0 : best - 1]),
      std::log(exponents[std::min(best + 1, offsets.size() - 1)]), 20, steps);
  const auto [p, w] = peak_expansion(measure);
  const auto law = offset_law(p, w);
  const double slope = blunt_slope(measure), first = exponents.front(), last = exponents.back();
  // The next terms of both laws have coefficients of the order of one.
  const bool laws_hold = std::abs(offsets.front() / (slope * first) - 1) < 10 * first &&
                         std::abs(offsets.back() - law.limit - law.slope / last) < 10 / (last * last);
  return OffsetRange{measure,
                     offsets[least],
                     exponents[least],
                     std::max(offsets[best], -peak.second),
                     -peak.second >= offsets[best] ? std::exp(peak.first) : exponents[best],
                     slope,
                     law,
                     laws_hold};
}

std::string sentence(const OffsetRange& range) {
  const std::string law = fmt::format("{:.4g}{}{:.4g}/k", range.law.limit,
                                      range.law.slope < 0 ? " - " : " + ", std::abs(range.law.slope));
  const bool is_below_limit = range.highest < range.law.limit;
  return fmt::format(
      "under the {} measure the best x is {:.4g} k for small k ({:.4g} at k = {}){} for large k",
      name(range.measure), range.blunt_slope, range.lowest, exponent_text(range.lowest_at),
      is_below_limit ? fmt::format(" and rises as {}", law)
                     : fmt::format(", has its maximum {:.4g} at k = {:.3g} and is {}", range.highest,
                                   range.highest_at, law));
}

Extremum largest_lobe_error(double exponent, double offset) {
  return largest_magnitude(error(exponent, offset), places(exponent));
}

double largest_lobe_codes(double exponent, double offset) {
  return largest_codes(gaussian(exponent, offset), target(exponent), exponent);
}

Extremum largest_offset_difference(double exponent, double offset, double other) {
  const auto a = gaussian(exponent, offset), b = gaussian(exponent, other);
  return largest_magnitude([&]<class T>(const Cosine<T>& c) { return T(a(c) - b(c)); }, places(exponent));
}

double largest_offset_codes(double exponent, double offset, double other) {
  return largest_codes(gaussian(exponent, offset), gaussian(exponent, other), exponent);
}

std::optional<double> best_offset(double exponent, Measure measure) {
  const Fit optimum = find_family("sg-offset")->fit(exponent, {.measure = measure});
  return optimum.status == Status::converged ? std::optional(optimum.parameters[0]) : std::nullopt;
}

SmallestLobeError smallest_lobe_error(double exponent) {
  const Substitution substitution = places(exponent);
  // The largest error above c^k for the sign 1, below it for -1.
  const auto excess = [&](double offset, int sign) {
    const auto above = [&]<class T>(const Cosine<T>& c) {
      return positive_part(T(integer<T>(sign) * error(exponent, offset)(c)));
    };
    return largest_magnitude(above, substitution).magnitude;
  };
  const auto imbalance = [&](double offset) { return excess(offset, 1) - excess(offset, -1); };
  const double offset = root_between(imbalance, 0, 2, 34);
  return {offset, excess(offset, 1)};
}

std::optional<Cosine<double>> peak_crossing(double exponent, double offset) {
  if (!(offset > 0)) return std::nullopt;
  // The residual is not negative at y = x/k, as -log(c^k/exp(-k y)) >= k y^2/2 and log((1 + e^(-x y))/2) >=
  // -x y/2, nor close enough to the horizon; it is negative close to the peak.
  const bool is_blunt = exponent <= 2 * offset;
  const auto place = [&](double s) {
    return is_blunt ? Cosine<double>{std::exp(-s), -std::expm1(-s)} : Cosine<double>{1 - s, s};
  };
  const auto residual = [&](double s) {
    const Cosine<double> c = place(s);
    return peak_crossing_residual(c.cos_theta, c.one_minus_cos, exponent, offset);
  };
  double high = is_blunt ? 1 : offset / exponent;
  while (is_blunt && residual(high) < 0) high *= 2;
  double low = high / 2;
  while (residual(low) >= 0) low /= 2;
  return place(root_between(residual, low, high, 48));
}

double lobe_error_at(const Cosine<double>& c, double exponent, double offset) {
  return std::abs(error(exponent, offset)(c));
}

void show_gaussian(Effect& effect, const Cosine<double>& c, double exponent, double offset) {
  effect.show(target(exponent)(c), gaussian(exponent, offset)(c), at_cosine(c));
}

Effect effect_of_gaussian(double exponent, double offset) {
  return effect_between(target(exponent), gaussian(exponent, offset), places(exponent));
}

Effect effect_of_offset(double exponent, double from, double to) {
  return effect_between(gaussian(exponent, from), gaussian(exponent, to), places(exponent));
}

}  // namespace shadefit
