#include "scene/lobe_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "approx/lobe.hpp"
#include "fit/enclosure.hpp"
#include "fit/family_visit.hpp"

namespace shadefit::scene {
namespace {

/// |f - t| min(g, 1/max(f, t)), with the difference given.
template <class T>
T shown_error(const T& difference, const T& form, const T& target, const T& factor) {
  return difference * min(factor, T(integer<T>(1) / max(form, target)));
}

constexpr double golden = 0.6180339887498949;  // (sqrt 5 - 1)/2

}  // namespace

double gaussian_error(const WeightedPower& lobe, double offset, double enough) {
  const auto family = make_family<SgOffset>(Setting(lobe.power));
  const auto shown = [&]<class T>(const Cosine<T>& c) {
    const std::array p{lift<T>(offset)};
    const auto sample = family.sample(c);
    const T difference = family.error(sample, p), form = family.form(sample, p);
    if (lobe.factor <= 1) return T(lift<T>(lobe.factor) * difference);
    return shown_error(difference, form, T(form - difference), lift<T>(lobe.factor));
  };
  return enclose_largest(shown, Domain{}, {.width = 0.02, .least = enough}).upper;
}

double sampled_gaussian_error(const WeightedPower& lobe, double offset) {
  // Lobes of every width fall alike with t = n y: 64 places up to t = 16 see the error to some percent.
  constexpr int places = 64;
  double largest = 0;
  for (int i = 0; i <= places; ++i) {
    const double y = std::min(1.0, 0.25 * i / lobe.power);
    const double target = y < 1 ? power_lobe_near_peak(y, lobe.power) : 0;
    const double form = gaussian_lobe_near_peak(y, lobe.power, offset);
    const double larger = std::max(form, target);
    if (larger > 0) largest = std::max(largest, std::abs(form - target) * std::min(lobe.factor, 1 / larger));
  }
  return largest;
}

double best_offset(std::span<const WeightedPower> lobes) {
  const auto error = [&](double offset) {
    double largest = 0;
    for (const WeightedPower& lobe : lobes) {
      if (lobe.power > 0) largest = std::max(largest, sampled_gaussian_error(lobe, offset));
    }
    return largest;
  };
  // The largest of functions that fall and then rise does so too: the golden section.
  double low = 0, high = 1.5;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double error_at_a = error(a), error_at_b = error(b);
  constexpr double near = 1e-4;
  while (high - low > near) {
    if (error_at_a <= error_at_b) {
      high = b;
      b = a;
      error_at_b = error_at_a;
      a = high - golden * (high - low);
      error_at_a = error(a);
    } else {
      low = a;
      a = b;
      error_at_a = error_at_b;
      b = low + golden * (high - low);
      error_at_b = error(b);
    }
  }
  return low + (high - low) / 2;
}

}  // namespace shadefit::scene
